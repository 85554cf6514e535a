#include "grader/Comparison.h"

#include <algorithm>
#include <cmath>

namespace ray::grade {
namespace {

double Square(double number) { return number * number; }

std::size_t IndexOf(const R2::Image& image, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(image.Width()) + static_cast<std::size_t>(x);
}

/// Returns three standard deviations of the mean of the runs, for each cell.
std::vector<double> NoiseOf(const std::vector<R2::Image>& runs, const R2::Image& mean, const SceneImages& images) {
  std::vector<double> noise(images.Cells(mean).Channels().size() / 3, 0.0);
  if (runs.size() < 2) return noise;
  const R2::Image middle = images.Cells(mean);
  for (const R2::Image& run : runs) {
    const R2::Image cells = images.Cells(run);
    for (int y = 0; y < cells.Height(); ++y)
      for (int x = 0; x < cells.Width(); ++x)
        noise[IndexOf(cells, x, y)] += Square(LargestChannel(cells.At(x, y) - middle.At(x, y)));
  }
  const auto count = static_cast<double>(runs.size());
  for (double& each : noise) each = 3 * std::sqrt(each / (count * (count - 1)));
  return noise;
}

R2::Image MeanOfRuns(const std::vector<R2::Image>& runs) {
  R2::Image mean(runs[0].Width(), runs[0].Height());
  for (int y = 0; y < mean.Height(); ++y)
    for (int x = 0; x < mean.Width(); ++x) {
      R2::Color sum;
      for (const R2::Image& run : runs) sum += run.At(x, y);
      mean.Set(x, y, sum / static_cast<double>(runs.size()));
    }
  return mean;
}

}  // namespace

Submission MakeSubmission(const std::vector<R2::Image>& runs, const SceneImages& images,
                          const std::vector<double>& losses) {
  Submission student{.image = MeanOfRuns(runs), .cells = {}, .tolerance = {}};
  student.cells = images.Cells(student.image);
  student.tolerance = NoiseOf(runs, student.image, images);
  for (double& each : student.tolerance) each += images.scene().tolerance;
  if (images.CellSide() == 1)
    for (std::size_t i = 0; i < student.tolerance.size(); ++i) student.tolerance[i] += images.Spread()[i];
  for (std::size_t i = 0; i < losses.size(); ++i) student.tolerance[i] += losses[i];
  return student;
}

Comparison Compare(const Submission& student, const SceneImages& images) {
  return Compare(student, images.Cells(images.Reference()), images);
}

Comparison Compare(const Submission& student, const R2::Image& reference, const SceneImages& images) {
  Comparison found;
  found.differs.assign(student.tolerance.size(), false);
  std::vector<double> differences(student.tolerance.size(), 0.0);
  for (int y = 0; y < reference.Height(); ++y)
    for (int x = 0; x < reference.Width(); ++x) {
      const std::size_t i = IndexOf(reference, x, y);
      if (images.CellSide() == 1 && !images.Steady()[i]) continue;
      const double difference = LargestChannel(student.cells.At(x, y) - reference.At(x, y));
      ++found.steady;
      if (!(difference > student.tolerance[i])) continue;
      ++found.differing;
      found.differs[i] = true;
      differences[i] = difference;
    }
  double& most = found.worst;
  for (int y = 0; y < reference.Height(); ++y)
    for (int x = 0; x < reference.Width(); ++x) {
      if (!found.differs[IndexOf(reference, x, y)]) continue;
      double around = 0;
      for (int j = std::max(0, y - 2); j <= std::min(reference.Height() - 1, y + 2); ++j)
        for (int i = std::max(0, x - 2); i <= std::min(reference.Width() - 1, x + 2); ++i)
          around += differences[IndexOf(reference, i, j)];
      if (around > most) most = around, found.worst_x = x, found.worst_y = y;
    }
  found.worst_x = std::min(found.worst_x * images.CellSide() + images.CellSide() / 2, images.Reference().Width() - 1);
  found.worst_y = std::min(found.worst_y * images.CellSide() + images.CellSide() / 2, images.Reference().Height() - 1);
  return found;
}

}  // namespace ray::grade
