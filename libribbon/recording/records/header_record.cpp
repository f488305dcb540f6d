#include "recording/records/header_record.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "recording/codec/column_loops.h"
#include "recording/coding/bytes.h"
#include "recording/coding/compression.h"

namespace ribbon {

namespace {

constexpr std::uint16_t major_version = 7;
constexpr std::uint16_t minor_version = 0;
constexpr std::uint32_t position_codec = 7;
constexpr std::uint32_t most_particles = 1U << 24;
// Columns have a border, so that many short ones take more memory than their particles.
constexpr int most_columns = 1 << 20;
constexpr std::int32_t largest_mesh = 1 << 26;
constexpr std::uint32_t most_curve_points = most_particles / 2;  // one a row

// The fields of the header are listed once, in functions that are given one of these two.

// Appends fields.
class FieldPutter {
 public:
  explicit FieldPutter(std::string& bytes) : bytes_(bytes) {}

  template <class Stored, class Number>
  void number(const Number& number) {
    put<Stored>(bytes_, static_cast<Stored>(number));
  }
  void text(std::string_view text) { put_string(bytes_, text); }

  // The number of columns, then all of them in a compressed block.
  template <class Matrix>
  void matrix(const Matrix& matrix, [[maybe_unused]] std::uint32_t most) {
    assert(matrix.cols() <= most);
    number<std::uint32_t>(matrix.cols());
    std::string content;
    for (const auto element : matrix.reshaped()) put<typename Matrix::Scalar>(content, element);
    text(Compressor().compress(content));
  }

  // Whether it is there, then its fields: fields(value).
  template <class Value, class Fields>
  void optional(const std::optional<Value>& value, const Fields& fields) {
    number<std::uint8_t>(value ? 1 : 0);
    if (value) fields(*value);
  }
  // How many there are, then the fields of each.
  template <class Value, class Fields>
  void list(const std::vector<Value>& values, [[maybe_unused]] std::uint32_t most,
            const Fields& fields) {
    assert(values.size() <= most);
    number<std::uint32_t>(values.size());
    for (const Value& value : values) fields(value);
  }

 private:
  std::string& bytes_;
};

// Takes the same fields off the front of a payload. After something that is not there, or of which
// there are more than allowed, everything is zero or empty and valid() is false.
class FieldTaker {
 public:
  explicit FieldTaker(std::string_view payload) : taker_(payload) {}

  template <class Stored, class Number>
  void number(Number& number) {
    number = static_cast<Number>(taker_.take<Stored>());
  }
  void text(std::string& text) { text = take_string(taker_); }

  // Allocated only where the block holds exactly so many columns.
  template <class Matrix>
  void matrix(Matrix& matrix, std::uint32_t most) {
    const std::uint32_t columns = count(most);
    const std::string_view block = taker_.take_bytes(taker_.take<std::uint32_t>());
    const std::size_t size = sizeof(typename Matrix::Scalar) * Matrix::RowsAtCompileTime * columns;
    Decompressor decompressor;
    const auto content = decompressor.decompress(block, size);
    if (!content || content->size() != size) return fail();
    matrix.resize(Eigen::NoChange, columns);
    ByteTaker elements(*content);
    for (auto& element : matrix.reshaped()) element = elements.take<typename Matrix::Scalar>();
  }

  template <class Value, class Fields>
  void optional(std::optional<Value>& value, const Fields& fields) {
    if (taker_.take<std::uint8_t>() != 0) fields(value.emplace());
  }
  template <class Value, class Fields>
  void list(std::vector<Value>& values, std::uint32_t most, const Fields& fields) {
    for (std::uint32_t left = count(most); left > 0 && valid(); --left)
      fields(values.emplace_back());
  }

  [[nodiscard]] bool valid() const { return taker_.complete() && !failed_; }
  [[nodiscard]] std::string_view rest() const { return taker_.rest(); }

 private:
  std::uint32_t count(std::uint32_t most) {
    const auto count = taker_.take<std::uint32_t>();
    if (count <= most) return count;
    fail();
    return 0;
  }
  void fail() { failed_ = true; }

  ByteTaker taker_;
  bool failed_ = false;
};

// What all versions begin with, from 2 on.
template <class Fields, class Header>
void first_fields(Fields& fields, Header& header) {
  fields.template number<std::uint32_t>(header.grid.along);
  fields.template number<std::uint32_t>(header.grid.across);
  for (auto* number : {&header.ribbon_length_m, &header.ribbon_width_m, &header.frames_per_second,
                       &header.max_position_error_m, &header.quantisation_step_m})
    fields.template number<double>(*number);
  fields.text(header.scene_name);
  fields.text(header.writer);
}

// Bits of edges; others are of later versions.
template <class Fields, class Header>
void limit_fields(Fields& fields, Header& header) {
  LimitedEdges edges = header.limited_edges;
  unsigned bits = (edges.along ? 1U : 0U) | (edges.across ? 2U : 0U) | (edges.diagonals ? 4U : 0U);
  fields.template number<std::uint8_t>(bits);
  edges = {.along = (bits & 1) != 0, .across = (bits & 2) != 0, .diagonals = (bits & 4) != 0};
  if constexpr (!std::is_const_v<Header>) header.limited_edges = edges;
  fields.template number<double>(header.strain_limit);
}

template <class Fields, class Header>
void row_width_fields(Fields& fields, Header& header) {
  Eigen::RowVectorXf widths =
      Eigen::RowVectorXd::Map(header.row_widths_m.data(), std::ssize(header.row_widths_m))
          .template cast<float>();
  fields.matrix(widths, most_particles);
  if constexpr (!std::is_const_v<Header>) header.row_widths_m.assign(widths.begin(), widths.end());
}

template <class Fields, class Header>
void other_fields(Fields& fields, Header& header) {
  const auto text = [&](auto& string) { fields.text(string); };
  const auto number = [&](auto& value) { fields.template number<double>(value); };
  fields.text(header.scene_text);
  fields.matrix(header.uv, most_particles);
  fields.optional(header.obstacle, [&](auto& mesh) {
    fields.text(mesh.name);
    fields.matrix(mesh.vertices, largest_mesh);
    fields.matrix(mesh.triangles, largest_mesh);
  });
  number(header.stated_gap_m);
  fields.optional(header.centre_axis, [&](auto& axis) {
    std::for_each(axis.point_m.begin(), axis.point_m.end(), number);
    std::for_each(axis.direction.begin(), axis.direction.end(), number);
  });
  fields.optional(header.origin, [&](auto& origin) {
    fields.template number<std::uint32_t>(origin.recording_id);
    fields.text(origin.scene_name);
    fields.template number<std::uint32_t>(origin.frame);
    fields.text(origin.changed_settings);
  });
  limit_fields(fields, header);
  fields.matrix(header.input_curve, most_curve_points);
  fields.list(header.stages, most_recorded_stages, text);
  fields.list(header.marks, most_recorded_marks, [&](auto& mark) {
    fields.text(mark.name);
    number(mark.share);
  });
  fields.optional(header.knot_between, [&](auto& between) {
    std::for_each(between.shares.begin(), between.shares.end(), number);
    fields.text(between.expected);
  });
  row_width_fields(fields, header);
}

bool is_share(double share) {
  return share >= 0 && share <= 1;  // false for NaN
}

bool is_mesh(const TriangleMesh& mesh) {
  const auto corners = mesh.triangles.reshaped().array();
  return mesh.vertices.allFinite() && (corners >= 0).all() &&
         (corners < static_cast<int>(mesh.vertices.cols())).all();
}

bool is_axis(const CentreAxis& axis) {
  return axis.point_m.allFinite() && std::abs(axis.direction.norm() - 1) < 1e-6;
}

// Their mean must be the ribbon's width, or what goes by the one contradicts what goes by the
// others.
bool are_row_widths(const std::vector<double>& widths_m, const RibbonGrid& grid, double mean_m) {
  if (widths_m.empty()) return true;
  const double sum_m = std::accumulate(widths_m.begin(), widths_m.end(), 0.0);
  return std::ssize(widths_m) == grid.along &&
         std::all_of(widths_m.begin(), widths_m.end(), is_positive) &&
         std::abs(sum_m / grid.along - mean_m) <= 1e-6 * mean_m;
}

// Positions must stay within single precision whatever their numbers are.
bool is_quantisation_step(double step_m) {
  return step_m >= 0 &&
         step_m * largest_quantised <= static_cast<double>(std::numeric_limits<float>::max());
}

bool is_valid(const RecordingHeader& header) {
  const auto& between = header.knot_between;
  return is_recordable(header.grid) && header.uv.cols() == header.grid.particle_count() &&
         header.uv.allFinite() && !header.scene_name.empty() &&
         is_positive(header.ribbon_length_m) && is_positive(header.ribbon_width_m) &&
         is_positive(header.frames_per_second) &&
         is_positive_or_zero(header.max_position_error_m) &&
         is_quantisation_step(header.quantisation_step_m) &&
         is_positive_or_zero(header.stated_gap_m) && is_positive_or_zero(header.strain_limit) &&
         (!header.obstacle || is_mesh(*header.obstacle)) &&
         (!header.centre_axis || is_axis(*header.centre_axis)) && header.input_curve.cols() != 1 &&
         header.input_curve.allFinite() &&
         std::all_of(header.marks.begin(), header.marks.end(),
                     [](const RecordedMark& mark) { return is_share(mark.share); }) &&
         (!between || (is_share(between->shares[0]) && is_share(between->shares[1]))) &&
         are_row_widths(header.row_widths_m, header.grid, header.ribbon_width_m);
}

tl::unexpected<Error> damaged() {
  return failure("", "the header is not valid", "use a copy of the recording that is not damaged");
}

// fields: behind the version and the codec.
tl::unexpected<Error> other_version(int major, int minor, FieldTaker fields) {
  RecordingHeader header;
  first_fields(fields, header);
  const bool is_told = major > 1 && fields.valid() && !header.writer.empty();
  return failure("",
                 "was written in format version " + std::to_string(major) + "." +
                     std::to_string(minor) + (is_told ? " by " + header.writer : "") +
                     ", this program reads version " + std::to_string(major_version),
                 major > major_version ? "use a newer program"
                 : is_told             ? "use that program, or record it again"
                                       : "record it again");
}

}  // namespace

bool is_positive(double number) {
  return std::isfinite(number) && number > 0;
}

bool is_positive_or_zero(double number) {
  return std::isfinite(number) && number >= 0;
}

bool is_recordable(const RibbonGrid& grid) {
  return grid.along >= 2 && grid.across >= 2 && grid.across <= most_columns &&
         std::int64_t{grid.along} * grid.across <= std::int64_t{most_particles};
}

Result<void> check_recordable(const RecordingHeader& header) {
  const RibbonGrid& grid = header.grid;
  if (!is_recordable(grid))
    return failure("",
                   "a recording holds at most 2^24 particles in at most 2^20 columns, not " +
                       std::to_string(grid.along) + " x " + std::to_string(grid.across),
                   "simulate fewer particles");
  const auto& mesh = header.obstacle;
  if (mesh && std::max(mesh->vertices.cols(), mesh->triangles.cols()) > largest_mesh)
    return failure("",
                   "a recording holds at most 2^26 vertices and as many triangles of its obstacle, "
                   "not " +
                       std::to_string(mesh->vertices.cols()) + " and " +
                       std::to_string(mesh->triangles.cols()),
                   "take a coarser mesh");
  if (!is_valid(header))
    return failure("", "no reader would take its header: a size, a rate or a bound is out of range",
                   "ask for a smaller position error, and give sizes in metres");
  return {};
}

std::string header_payload(const RecordingHeader& header) {
  std::string bytes;
  FieldPutter fields(bytes);
  fields.number<std::uint16_t>(major_version);
  fields.number<std::uint16_t>(minor_version);
  fields.number<std::uint32_t>(position_codec);
  first_fields(fields, header);
  other_fields(fields, header);
  return bytes;
}

Result<RecordingHeader> parse_header_payload(std::string_view payload) {
  FieldTaker fields(payload);
  std::uint16_t major = 0;
  std::uint16_t minor = 0;  // a newer one only appends
  std::uint32_t codec = 0;
  fields.number<std::uint16_t>(major);
  fields.number<std::uint16_t>(minor);
  fields.number<std::uint32_t>(codec);
  if (fields.valid() && major != major_version) return other_version(major, minor, fields);
  RecordingHeader header;
  first_fields(fields, header);
  other_fields(fields, header);
  if (codec != position_codec || !fields.valid() || !is_valid(header)) return damaged();
  return header;
}

}  // namespace ribbon
