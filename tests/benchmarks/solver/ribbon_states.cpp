#include "benchmarks/solver/ribbon_states.h"

#include <algorithm>

#include "benchmarks/sample_ribbon.h"
#include "playback/recording_reader.h"

namespace ribbon {

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// How far a step carries a particle and how close a pair must come to matter, in edges. The samples
// move by 0.28 edges a step at 400 particles along, and are repelled within 0.2.
constexpr double way_edges = 0.25;
constexpr double margin_edges = 0.2;

// Drawn from the middle toward its ends.
RibbonMotion in_motion(const RibbonGrid& grid, Matrix3Xd positions, double length_m,
                       double width_m) {
  const double edge_m = length_m / (grid.along - 1);
  Matrix3Xd moved = positions;
  for (int i = 0; i < grid.along; ++i) {
    const int back = std::max(i - 1, 0);
    const int ahead = std::min(i + 1, grid.along - 1);
    const double way_m = (2 * i < grid.along ? -1 : 1) * way_edges * edge_m;
    for (int j = 0; j < grid.across; ++j)
      moved.col(grid.particle(i, j)) +=
          way_m * (positions.col(grid.particle(ahead, j)) - positions.col(grid.particle(back, j)))
                      .normalized();
  }
  return {grid, std::move(positions), std::move(moved),
          margin_edges * std::min(edge_m, width_m / (grid.across - 1))};
}

// Column `at` of a line of points between which a cubic runs (uniform Catmull-Rom), its ends
// prolonged straight.
Vector3d on_cubic(const Matrix3Xd& line, double at) {
  const Eigen::Index last = line.cols() - 1;
  const Eigen::Index i = std::min(static_cast<Eigen::Index>(at), last - 1);
  const double t = at - static_cast<double>(i);
  const Vector3d b = line.col(i);
  const Vector3d c = line.col(i + 1);
  const Vector3d a = i > 0 ? Vector3d(line.col(i - 1)) : Vector3d(2 * b - c);
  const Vector3d d = i + 2 <= last ? Vector3d(line.col(i + 2)) : Vector3d(2 * c - b);
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

Matrix3Xd refined(const Matrix3Xd& line, int points) {
  Matrix3Xd result(3, points);
  for (int i = 0; i < points; ++i)
    result.col(i) = on_cubic(
        line, static_cast<double>(i) * static_cast<double>(line.cols() - 1) / (points - 1));
  return result;
}

// Across each row first, then along.
Matrix3Xd refined(const RibbonGrid& from, const Matrix3Xd& positions, const RibbonGrid& to) {
  const RibbonGrid wide{from.along, to.across};
  Matrix3Xd wider(3, wide.particle_count());
  for (int i = 0; i < from.along; ++i)
    wider.middleCols(wide.particle(i, 0), to.across) =
        refined(Matrix3Xd(positions.middleCols(from.particle(i, 0), from.across)), to.across);
  Matrix3Xd result(3, to.particle_count());
  for (int j = 0; j < to.across; ++j) {
    Matrix3Xd line(3, from.along);
    for (int i = 0; i < from.along; ++i) line.col(i) = wider.col(wide.particle(i, j));
    const Matrix3Xd longer = refined(line, to.along);
    for (int i = 0; i < to.along; ++i) result.col(to.particle(i, j)) = longer.col(i);
  }
  return result;
}

}  // namespace

Result<RibbonMotion> loose_ribbon(const std::filesystem::path& scene_file, int along, int across) {
  const auto ribbon = sample_ribbon(scene_file, along, across);
  if (!ribbon) return tl::unexpected(ribbon.error());
  const RibbonMesh& mesh = ribbon->mesh;
  return in_motion(mesh.grid, mesh.positions, mesh.length_m, mesh.width_m);
}

Result<RibbonMotion> tight_ribbon(const std::filesystem::path& recording, int along, int across) {
  auto reader = RecordingReader::open(recording);
  if (!reader) return tl::unexpected(reader.error());
  Eigen::Matrix3Xf last;
  if (auto read = reader->read(reader->frame_count() - 1, last); !read)
    return tl::unexpected(read.error());
  const RecordingHeader& header = reader->header();
  const RibbonGrid grid{along, across};
  return in_motion(grid, refined(header.grid, last.cast<double>(), grid), header.ribbon_length_m,
                   header.ribbon_width_m);
}

}  // namespace ribbon
