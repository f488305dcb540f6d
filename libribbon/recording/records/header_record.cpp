#include "recording/records/header_record.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "recording/codec/column_loops.h"
#include "recording/coding/bytes.h"
#include "recording/coding/compression.h"

namespace ribbon {

namespace {

constexpr std::uint16_t major_version = 6;
constexpr std::uint16_t minor_version = 0;
constexpr std::uint32_t position_codec = 6;
constexpr std::int64_t most_particles = std::int64_t{1} << 24;
// Columns have a border, so that many short ones take more memory than their particles.
constexpr int most_columns = 1 << 20;
constexpr std::uint64_t largest_mesh = std::uint64_t{1} << 26;
constexpr std::uint32_t most_curve_points = 1U << 20;
constexpr std::uint32_t most_stages = 255;

// A matrix column by column, as little-endian numbers in one compressed block.
template <class Stored, class Matrix>
void put_matrix(std::string& bytes, const Matrix& matrix) {
  std::string content;
  content.reserve(matrix.size() * sizeof(Stored));
  for (const auto number : matrix.reshaped()) put<Stored>(content, static_cast<Stored>(number));
  put_string(bytes, Compressor().compress(content));
}

// The inverse; nothing where the block does not hold exactly `columns` columns. The matrix is
// allocated only then.
template <class Stored, class Matrix>
bool take_matrix(ByteTaker& taker, std::uint64_t columns, Matrix& matrix) {
  const std::string_view block = taker.take_bytes(taker.take<std::uint32_t>());
  const std::uint64_t expected = columns * Matrix::RowsAtCompileTime * sizeof(Stored);
  Decompressor decompressor;
  const auto content = decompressor.decompress(block, static_cast<std::size_t>(expected));
  if (!content || content->size() != expected) return false;
  matrix.resize(Eigen::NoChange, static_cast<Eigen::Index>(columns));
  ByteTaker numbers(*content);
  for (auto& number : matrix.reshaped())
    number = static_cast<typename Matrix::Scalar>(numbers.take<Stored>());
  return true;
}

void put_obstacle(std::string& bytes, const TriangleMesh& mesh) {
  put_string(bytes, mesh.name);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(mesh.vertices.cols()));
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(mesh.triangles.cols()));
  put_matrix<float>(bytes, mesh.vertices);
  put_matrix<std::uint32_t>(bytes, mesh.triangles);
}

bool take_obstacle(ByteTaker& taker, TriangleMesh& mesh) {
  mesh.name = take_string(taker);
  const auto vertices = taker.take<std::uint32_t>();
  const auto triangles = taker.take<std::uint32_t>();
  if (vertices > largest_mesh || triangles > largest_mesh) return false;
  if (!take_matrix<float>(taker, vertices, mesh.vertices) ||
      !take_matrix<std::uint32_t>(taker, triangles, mesh.triangles))
    return false;
  const auto corners = mesh.triangles.reshaped();
  return mesh.vertices.allFinite() && (corners.array() >= 0).all() &&
         (corners.array() < static_cast<int>(vertices)).all();
}

void put_vector(std::string& bytes, const Eigen::Vector3d& vector) {
  for (const double component : vector) put<double>(bytes, component);
}

Eigen::Vector3d take_vector(ByteTaker& taker) {
  Eigen::Vector3d vector;
  for (double& component : vector) component = taker.take<double>();
  return vector;
}

bool is_axis(const CentreAxis& axis) {
  return axis.point_m.allFinite() && std::abs(axis.direction.norm() - 1) < 1e-6;
}

void put_axis(std::string& bytes, const std::optional<CentreAxis>& axis) {
  put<std::uint8_t>(bytes, axis ? 1 : 0);
  if (!axis) return;
  put_vector(bytes, axis->point_m);
  put_vector(bytes, axis->direction);
}

bool take_axis(ByteTaker& taker, std::optional<CentreAxis>& axis) {
  if (taker.take<std::uint8_t>() == 0) return taker.complete();
  axis.emplace();
  axis->point_m = take_vector(taker);
  axis->direction = take_vector(taker);
  return taker.complete() && is_axis(*axis);
}

void put_strings(std::string& bytes, const std::vector<std::string>& strings) {
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(strings.size()));
  for (const std::string& string : strings) put_string(bytes, string);
}

bool take_strings(ByteTaker& taker, std::uint32_t most, std::vector<std::string>& strings) {
  const auto count = taker.take<std::uint32_t>();
  if (count > most) return false;
  for (std::uint32_t i = 0; i < count; ++i) strings.push_back(take_string(taker));
  return taker.complete();
}

void put_origin(std::string& bytes, const std::optional<Origin>& origin) {
  put<std::uint8_t>(bytes, origin ? 1 : 0);
  if (!origin) return;
  put<std::uint32_t>(bytes, origin->recording_id);
  put_string(bytes, origin->scene_name);
  put<std::uint32_t>(bytes, origin->frame);
  put_string(bytes, origin->changed_settings);
}

bool take_origin(ByteTaker& taker, std::optional<Origin>& origin) {
  if (taker.take<std::uint8_t>() == 0) return taker.complete();
  origin.emplace();
  origin->recording_id = taker.take<std::uint32_t>();
  origin->scene_name = take_string(taker);
  origin->frame = taker.take<std::uint32_t>();
  origin->changed_settings = take_string(taker);
  return taker.complete();
}

constexpr std::uint8_t along_bit = 1;
constexpr std::uint8_t across_bit = 2;
constexpr std::uint8_t diagonals_bit = 4;

void put_limited_edges(std::string& bytes, const LimitedEdges& edges) {
  put<std::uint8_t>(bytes, (edges.along ? along_bit : 0) | (edges.across ? across_bit : 0) |
                               (edges.diagonals ? diagonals_bit : 0));
}

LimitedEdges take_limited_edges(ByteTaker& taker) {
  const auto bits = taker.take<std::uint8_t>();
  return {.along = (bits & along_bit) != 0,
          .across = (bits & across_bit) != 0,
          .diagonals = (bits & diagonals_bit) != 0};
}

void put_curve(std::string& bytes, const Eigen::Matrix3Xf& points) {
  assert(points.cols() != 1 && points.cols() <= most_curve_points);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(points.cols()));
  if (points.cols() > 0) put_matrix<float>(bytes, points);
}

bool take_curve(ByteTaker& taker, Eigen::Matrix3Xf& points) {
  const auto count = taker.take<std::uint32_t>();
  if (count == 0) return taker.complete();
  return count >= 2 && count <= most_curve_points && take_matrix<float>(taker, count, points) &&
         points.allFinite();
}

void put_marks(std::string& bytes, const std::vector<RecordedMark>& marks) {
  assert(marks.size() <= most_recorded_marks);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(marks.size()));
  for (const RecordedMark& mark : marks) {
    put_string(bytes, mark.name);
    put<double>(bytes, mark.share);
  }
}

bool is_share(double share) {
  return share >= 0 && share <= 1;  // false for NaN
}

bool take_marks(ByteTaker& taker, std::vector<RecordedMark>& marks) {
  const auto count = taker.take<std::uint32_t>();
  if (count > most_recorded_marks) return false;
  for (std::uint32_t i = 0; i < count; ++i) {
    RecordedMark mark{take_string(taker)};
    mark.share = taker.take<double>();
    if (!taker.complete() || !is_share(mark.share)) return false;
    marks.push_back(std::move(mark));
  }
  return taker.complete();
}

void put_knot_between(std::string& bytes, const std::optional<KnotBetween>& between) {
  put<std::uint8_t>(bytes, between ? 1 : 0);
  if (!between) return;
  for (const double share : between->shares) put<double>(bytes, share);
  put_string(bytes, between->expected);
}

bool take_knot_between(ByteTaker& taker, std::optional<KnotBetween>& between) {
  if (taker.take<std::uint8_t>() == 0) return taker.complete();
  between.emplace();
  for (double& share : between->shares) share = taker.take<double>();
  between->expected = take_string(taker);
  return taker.complete() && is_share(between->shares[0]) && is_share(between->shares[1]);
}

tl::unexpected<Error> damaged() {
  return failure("", "the header is not valid", "use a copy of the recording that is not damaged");
}

// All versions from 2 on begin alike, as far as the program that wrote them.
tl::unexpected<Error> other_version(int major, int minor, ByteTaker taker) {
  taker.take_bytes(3 * sizeof(std::uint32_t) + 5 * sizeof(double));
  take_string(taker);
  const std::string writer = take_string(taker);
  const bool is_told = major > 1 && taker.complete() && !writer.empty();
  return failure("",
                 "was written in format version " + std::to_string(major) + "." +
                     std::to_string(minor) + (is_told ? " by " + writer : "") +
                     ", this program reads version " + std::to_string(major_version),
                 major > major_version ? "use a newer program"
                 : is_told             ? "use that program, or record it again"
                                       : "record it again");
}

bool is_positive(double number) {
  return std::isfinite(number) && number > 0;
}

// Positions must stay within single precision whatever their numbers are.
bool is_quantisation_step(double step_m) {
  return step_m >= 0 &&
         step_m * largest_quantised <= static_cast<double>(std::numeric_limits<float>::max());
}

bool is_positive_or_zero(double number) {
  return std::isfinite(number) && number >= 0;
}

// The counts of the grid, bounded before anything is made of them.
bool take_grid(ByteTaker& taker, RibbonGrid& grid) {
  const auto along = taker.take<std::uint32_t>();
  const auto across = taker.take<std::uint32_t>();
  constexpr std::uint32_t largest = std::numeric_limits<int>::max();
  if (along > largest || across > largest) return false;
  grid = {static_cast<int>(along), static_cast<int>(across)};
  return is_recordable(grid);
}

void put_row_widths(std::string& bytes, const std::vector<double>& widths_m) {
  put<std::uint8_t>(bytes, widths_m.empty() ? 0 : 1);
  if (widths_m.empty()) return;
  put_matrix<float>(bytes, Eigen::RowVectorXd::Map(widths_m.data(), std::ssize(widths_m)));
}

// Their mean must be the ribbon's width, or what goes by the one contradicts what goes by the
// others.
bool take_row_widths(ByteTaker& taker, const RibbonGrid& grid, double mean_m,
                     std::vector<double>& widths_m) {
  if (taker.take<std::uint8_t>() == 0) return taker.complete();
  Eigen::Matrix<float, 1, Eigen::Dynamic> widths;
  if (!take_matrix<float>(taker, static_cast<std::uint64_t>(grid.along), widths)) return false;
  widths_m.assign(widths.begin(), widths.end());
  const double sum_m = std::accumulate(widths_m.begin(), widths_m.end(), 0.0);
  return std::all_of(widths_m.begin(), widths_m.end(), is_positive) &&
         std::abs(sum_m / grid.along - mean_m) <= 1e-6 * mean_m;
}

}  // namespace

bool is_recordable(const RibbonGrid& grid) {
  return grid.along >= 2 && grid.across >= 2 && grid.across <= most_columns &&
         std::int64_t{grid.along} * grid.across <= most_particles;
}

std::string header_payload(const RecordingHeader& header) {
  std::string bytes;
  put<std::uint16_t>(bytes, major_version);
  put<std::uint16_t>(bytes, minor_version);
  put<std::uint32_t>(bytes, position_codec);
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(header.grid.along));
  put<std::uint32_t>(bytes, static_cast<std::uint32_t>(header.grid.across));
  put<double>(bytes, header.ribbon_length_m);
  put<double>(bytes, header.ribbon_width_m);
  put<double>(bytes, header.frames_per_second);
  put<double>(bytes, header.max_position_error_m);
  put<double>(bytes, header.quantisation_step_m);
  put_string(bytes, header.scene_name);
  put_string(bytes, header.writer);
  put_string(bytes, header.scene_text);
  put_matrix<float>(bytes, header.uv);
  put<std::uint8_t>(bytes, header.obstacle ? 1 : 0);
  if (header.obstacle) put_obstacle(bytes, *header.obstacle);
  put<double>(bytes, header.stated_gap_m);
  put_axis(bytes, header.centre_axis);
  put_origin(bytes, header.origin);
  put_limited_edges(bytes, header.limited_edges);
  put<double>(bytes, header.strain_limit);
  put_curve(bytes, header.input_curve);
  assert(header.stages.size() <= most_stages);
  put_strings(bytes, header.stages);
  put_marks(bytes, header.marks);
  put_knot_between(bytes, header.knot_between);
  assert(header.row_widths_m.empty() || std::ssize(header.row_widths_m) == header.grid.along);
  put_row_widths(bytes, header.row_widths_m);
  return bytes;
}

Result<RecordingHeader> parse_header_payload(std::string_view payload) {
  ByteTaker taker(payload);
  const auto major = taker.take<std::uint16_t>();
  const auto minor = taker.take<std::uint16_t>();  // a newer one only appends
  if (taker.complete() && major != major_version) return other_version(major, minor, taker);
  const auto codec = taker.take<std::uint32_t>();
  RecordingHeader header;
  if (codec != position_codec || !take_grid(taker, header.grid)) return damaged();
  header.ribbon_length_m = taker.take<double>();
  header.ribbon_width_m = taker.take<double>();
  header.frames_per_second = taker.take<double>();
  header.max_position_error_m = taker.take<double>();
  header.quantisation_step_m = taker.take<double>();
  header.scene_name = take_string(taker);
  header.writer = take_string(taker);
  header.scene_text = take_string(taker);
  const auto particles = static_cast<std::uint64_t>(header.grid.particle_count());
  if (!taker.complete() || !take_matrix<float>(taker, particles, header.uv)) return damaged();
  if (taker.take<std::uint8_t>() != 0 && !take_obstacle(taker, header.obstacle.emplace()))
    return damaged();
  header.stated_gap_m = taker.take<double>();
  if (!take_axis(taker, header.centre_axis) || !take_origin(taker, header.origin)) return damaged();
  header.limited_edges = take_limited_edges(taker);
  header.strain_limit = taker.take<double>();
  if (!take_curve(taker, header.input_curve) || !take_strings(taker, most_stages, header.stages) ||
      !take_marks(taker, header.marks) || !take_knot_between(taker, header.knot_between) ||
      !take_row_widths(taker, header.grid, header.ribbon_width_m, header.row_widths_m))
    return damaged();
  const bool valid = taker.complete() && !header.scene_name.empty() &&
                     is_positive(header.ribbon_length_m) && is_positive(header.ribbon_width_m) &&
                     is_positive(header.frames_per_second) &&
                     is_positive_or_zero(header.max_position_error_m) &&
                     is_quantisation_step(header.quantisation_step_m) &&
                     is_positive_or_zero(header.stated_gap_m) &&
                     is_positive_or_zero(header.strain_limit) && header.uv.allFinite();
  if (!valid) return damaged();
  return header;
}

}  // namespace ribbon
