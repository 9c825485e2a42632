#include "pipeline/parts/matrix_picture.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foldwright {
namespace {

constexpr int kMostRows = 256;  // what the interfaces promise, and more than a small canvas shows

}  // namespace

MatrixPicture make_matrix_picture(const FoldabilityMatrix& matrix, std::span<const int> labels) {
  const int n = matrix.size;
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  if (!labels.empty()) {
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return labels[a] < labels[b]; });
  }
  MatrixPicture picture;
  picture.size = std::min(n, kMostRows);
  const auto first_of = [&](int row) {
    return static_cast<int>(std::int64_t{row} * n / picture.size);
  };
  for (int row = 0; row < picture.size; ++row) {
    for (int column = 0; column < picture.size; ++column) {
      double sum = 0;
      for (int i = first_of(row); i < first_of(row + 1); ++i) {
        for (int j = first_of(column); j < first_of(column + 1); ++j) {
          sum += matrix(order[i], order[j]);
        }
      }
      const double cells = (first_of(row + 1) - first_of(row)) *
                           static_cast<double>(first_of(column + 1) - first_of(column));
      picture.values.push_back(static_cast<std::uint8_t>(std::lround(255 * sum / cells)));
    }
  }
  for (int i = 0; i < n && !labels.empty(); ++i) {
    if (i > 0 && labels[order[i]] == labels[order[i - 1]]) continue;
    picture.blocks.push_back(static_cast<int>(std::int64_t{i} * picture.size / n));
  }
  return picture;
}

}  // namespace foldwright
