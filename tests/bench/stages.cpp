// Times the stages of a job. Arguments: numbers of faces; all usual ones when none is given.
//
// Prints one JSON line per stage and number of faces, with the median of the seconds over some
// models: {"faces":1000,"stage":"learn","seconds":0.8}. Learning and clustering are those of a job
// for 8 parts, with a proxy above 1000 faces as in any job; `search-whole` is the search of the
// whole model as one net.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "meshes.h"
#include "pipeline/job.h"
#include "shared_models.h"

namespace foldwright::testing {
namespace {

constexpr int kUsualSizes[] = {300, 574, 1000, 2000, 3000, 5000};

// Closed and organic, from smooth to limbed.
constexpr const char* kModels[] = {"spot", "hand", "koala", "fish", "nefertiti"};

using Seconds = std::map<StageId, double>;

/// The models of one size as OBJ; bumpy spheres where the shared ones are missing.
std::vector<std::string> models_of(int faces) {
  std::vector<std::string> texts;
  for (const char* name : kModels) {
    const std::string file = std::string(name) + "_" + std::to_string(faces) + ".obj";
    const auto path = shared_folder() / "models/organic" / file;
    if (std::filesystem::exists(path)) texts.push_back(bytes_of(path));
  }
  if (texts.empty()) texts.push_back(obj_of(bumpy_sphere(faces)));
  return texts;
}

/// Seconds that each stage of one job takes.
Seconds time_job(const std::string& text, int parts) {
  using Clock = std::chrono::steady_clock;
  const auto bytes = std::as_bytes(std::span(text));
  Job job({{"model.obj", {bytes.begin(), bytes.end()}}}, {.parts = {.count = parts}});
  Seconds seconds;
  StageId stage = StageId::kRead;
  while (!job.finished()) {
    const auto start = Clock::now();
    const Events events = job.step(20000);
    for (const Event& event : events) {
      if (const auto* said = std::get_if<StageEvent>(&event)) stage = said->stage;
    }
    seconds[stage] += std::chrono::duration<double>(Clock::now() - start).count();
    if (events.empty()) continue;
    if (const auto* error = std::get_if<ErrorEvent>(&events.back())) {
      std::fprintf(stderr, "%s\n", describe(error->message).c_str());
      std::exit(1);
    }
  }
  return seconds;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

void print(int faces, const char* stage, const std::vector<Seconds>& jobs, StageId id) {
  std::vector<double> values;
  for (const Seconds& seconds : jobs) values.push_back(seconds.contains(id) ? seconds.at(id) : 0);
  std::printf("{\"faces\":%d,\"stage\":\"%s\",\"seconds\":%.4f}\n", faces, stage, median(values));
  std::fflush(stdout);
}

void measure(int faces) {
  std::vector<Seconds> in_parts, as_one;
  for (const std::string& text : models_of(faces)) {
    in_parts.push_back(time_job(text, 8));
    as_one.push_back(time_job(text, 1));
  }
  print(faces, "learn", in_parts, StageId::kLearn);
  print(faces, "cluster", in_parts, StageId::kCluster);
  print(faces, "search-8-parts", in_parts, StageId::kSearch);
  print(faces, "search-whole", as_one, StageId::kSearch);
}

}  // namespace
}  // namespace foldwright::testing

int main(int count, char** arguments) {
  std::vector<int> sizes;
  for (int i = 1; i < count; ++i) sizes.push_back(std::atoi(arguments[i]));
  if (sizes.empty()) {
    sizes.assign(std::begin(foldwright::testing::kUsualSizes),
                 std::end(foldwright::testing::kUsualSizes));
  }
  for (const int faces : sizes) foldwright::testing::measure(faces);
}
