#include "benchmarks/accuracy/accuracy_figures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;

Measured measured(const std::vector<AccuracyRun>& runs,
                  const std::function<double(const AccuracyRun&)>& measure) {
  const auto count = static_cast<double>(runs.size());
  Measured result;
  for (const AccuracyRun& run : runs) result.mean += measure(run) / count;
  double squares = 0;
  for (const AccuracyRun& run : runs) squares += std::pow(measure(run) - result.mean, 2);
  if (runs.size() > 1) result.spread = std::sqrt(squares / (count - 1));
  return result;
}

// 3 x all samples of both ends.
Matrix3Xd path_of(const AccuracyRun& run) {
  Matrix3Xd path(3, 2 * static_cast<Eigen::Index>(run.ends.size()));
  for (std::size_t i = 0; i < run.ends.size(); ++i)
    path.middleCols<2>(2 * static_cast<Eigen::Index>(i)) = run.ends[i];
  return path;
}

Matrix3Xd mean_path(const std::vector<AccuracyRun>& runs) {
  Matrix3Xd sum = Matrix3Xd::Zero(3, path_of(runs.front()).cols());
  for (const AccuracyRun& run : runs) sum += path_of(run);
  return sum / static_cast<double>(runs.size());
}

// Squared standard deviation of the mean path, summed over its samples.
double squared_blur(const std::vector<AccuracyRun>& runs, const Matrix3Xd& mean) {
  if (runs.size() < 2) return 0;
  double squares = 0;
  for (const AccuracyRun& run : runs) squares += (path_of(run) - mean).squaredNorm();
  const auto count = static_cast<double>(runs.size());
  return squares / (count - 1) / count;
}

// Against how far the ends went from their first sample on.
Measured after_contact(const std::vector<AccuracyRun>& runs,
                       const std::vector<AccuracyRun>& converged) {
  const Matrix3Xd truth = mean_path(converged);
  const Matrix3Xd path = mean_path(runs);
  assert(truth.cols() == path.cols());
  const Matrix3Xd first = truth.leftCols<2>().replicate(1, truth.cols() / 2);
  const double way = (truth - first).norm();
  const double blur = std::sqrt(squared_blur(runs, path) + squared_blur(converged, truth));
  return {.mean = (path - truth).norm() / way, .spread = blur / way};
}

}  // namespace

AccuracyFigures figures_of(const AccuracySetting& setting, const AccuracyRuns& runs,
                           const AccuracyRuns& converged) {
  const AccuracyRun& before = runs.before_contact;
  const AccuracyRun& truth = converged.before_contact;
  const std::vector<AccuracyRun>& all = runs.fastenings;
  AccuracyFigures figures;
  figures.name = setting.name;
  figures.is_level = setting.is_level;
  figures.before_contact = (before.last - truth.last).norm() / (truth.last - truth.start).norm();
  figures.after_contact = after_contact(all, converged.fastenings);
  figures.processor_s =
      measured(all, [](const AccuracyRun& run) { return run.processor_s / run.simulated_s; }).mean;
  figures.tight_s =
      measured(all, [](const AccuracyRun& run) { return run.tight_s.value_or(run.simulated_s); });
  figures.rope_length = measured(all, [](const AccuracyRun& run) { return run.rope_length; });
  figures.ends_apart_m = measured(all, [](const AccuracyRun& run) {
    return (run.ends.back().col(1) - run.ends.back().col(0)).norm();
  });
  for (const AccuracyRun& run : all) {
    figures.worst_strain = std::max(figures.worst_strain, run.worst_strain);
    figures.energy = std::max(figures.energy, run.energy);
  }
  return figures;
}

bool beats(const AccuracyFigures& a, const AccuracyFigures& b) {
  constexpr double time_noise = 0.1;
  const double blur = std::hypot(a.after_contact.spread, b.after_contact.spread);
  return a.processor_s < (1 - time_noise) * b.processor_s && a.before_contact < b.before_contact &&
         a.after_contact.mean < b.after_contact.mean + blur;
}

}  // namespace ribbon
