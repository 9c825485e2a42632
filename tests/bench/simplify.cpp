// Our simplification beside OpenMesh's collapses (`decimate`): what comes of models, and processor
// seconds. `bench_simplify [FACES | FILE]...` takes the nine organic models of 5000 faces and the
// full scans, or the files; `bench_simplify --measure ORIGINAL SIMPLE TITLE BY SECONDS` prints the
// row of a mesh that another program made of a model (`simplify.mjs`).

#include "simplify/simplify.h"

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <string_view>

#include "mesh/decimate.h"
#include "shared_models.h"
#include "simplified.h"

namespace {

using namespace foldwright;
using namespace foldwright::testing;

void print_row(const char* model, const char* by, const Simplified& row, double seconds) {
  std::printf("%-21s %-13s %5d %6.2f %7.3f %7.2f %6.2f %6.2f %5d %8.3f\n", model, by, row.faces,
              row.deviation, row.mean_deviation, row.worst_angle, row.thin, row.low, row.crossings,
              seconds);
  std::fflush(stdout);
}

template <class Simplify>
void compare(const std::string& model, const char* by, const Mesh& mesh, Simplify&& simplify) {
  const std::clock_t start = std::clock();
  const Mesh simple = simplify(mesh);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  print_row(model.c_str(), by, measured(mesh, simple), seconds);
}

void compare_all(const std::string& name, const Mesh& mesh, int faces) {
  const std::string title = name + ' ' + std::to_string(faces);
  compare(title, "openmesh", mesh, [&](const Mesh& m) { return decimate(m, faces); });
  compare(title, "plain", mesh,
          [&](const Mesh& m) { return simplify(m, {.target_faces = faces}); });
  compare(title, "foldwright", mesh, [&](const Mesh& m) {
    return simplify(m, {.target_faces = faces, .keep_mirror = true, .keep_apart = true});
  });
}

std::vector<std::filesystem::path> usual_models() {
  std::vector<std::filesystem::path> models = files_below("models/organic");
  std::erase_if(models, [](const auto& path) {
    return path.filename().string().find("_5000") == std::string::npos;
  });
  for (const auto& path : files_below("models/full")) models.push_back(path);
  return models;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 7 && std::string_view(argv[1]) == "--measure") {
    print_row(argv[4], argv[5], measured(load(argv[2]).mesh, load(argv[3]).mesh),
              std::atof(argv[6]));
    return 0;
  }
  std::printf("%-21s %-13s %5s %6s %7s %7s %6s %6s %5s %8s\n", "model", "by", "faces", "far %",
              "mean %", "angle", "<15 %", "low %", "cross", "seconds");
  std::vector<int> sizes;
  std::vector<std::filesystem::path> models;
  for (int i = 1; i < argc; ++i) {
    if (const int faces = std::atoi(argv[i]); faces > 0)
      sizes.push_back(faces);
    else
      models.emplace_back(argv[i]);
  }
  if (sizes.empty()) sizes = {200, 500, 1000, 1500};
  if (models.empty()) models = usual_models();
  for (const auto& path : models) {
    const Mesh mesh = load(path).mesh;
    for (const int faces : sizes) compare_all(path.stem().string(), mesh, faces);
  }
  return 0;
}
