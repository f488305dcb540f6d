#include "recording/records/header_record.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "recording/coding/bytes.h"
#include "recording/coding/compression.h"
#include "recording/sample_recording.h"
#include "result/refusal.h"

namespace ribbon::header_record_test {

RecordingHeader with_row_widths() {
  RecordingHeader header = sample_header();
  for (int row = 0; row < header.grid.along; ++row)
    header.row_widths_m.push_back(static_cast<float>(
        header.ribbon_width_m * (0.5 + static_cast<double>(row) / (header.grid.along - 1))));
  return header;
}

TEST(HeaderRecord, everything_comes_back) {
  const RecordingHeader written = sample_header();
  const auto read = parse_header_payload(header_payload(written));
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_EQ(read->scene_name, written.scene_name);
  EXPECT_EQ(read->scene_text, written.scene_text);
  EXPECT_EQ(read->writer, written.writer);
  EXPECT_EQ(read->grid, written.grid);
  EXPECT_EQ(read->uv, written.uv);
  EXPECT_EQ(read->ribbon_length_m, written.ribbon_length_m);
  EXPECT_EQ(read->ribbon_width_m, written.ribbon_width_m);
  EXPECT_EQ(read->frames_per_second, written.frames_per_second);
  EXPECT_EQ(read->max_position_error_m, written.max_position_error_m);
  ASSERT_TRUE(read->obstacle.has_value());
  EXPECT_EQ(read->obstacle->name, "stone");
  EXPECT_EQ(read->obstacle->vertices, written.obstacle->vertices);
  EXPECT_EQ(read->obstacle->triangles, written.obstacle->triangles);
  EXPECT_EQ(read->stated_gap_m, 1e-4);
  EXPECT_EQ(read->limited_edges, written.limited_edges);
  EXPECT_EQ(read->strain_limit, 0.25);
  ASSERT_TRUE(read->centre_axis.has_value());
  EXPECT_EQ(read->centre_axis->point_m, Eigen::Vector3d(0, 0.5, 0));
  EXPECT_EQ(read->centre_axis->direction, Eigen::Vector3d(0, 0.6, 0.8));
  EXPECT_EQ(read->input_curve, written.input_curve);
}

TEST(HeaderRecord, a_ribbon_needs_no_axis_and_no_obstacle) {
  RecordingHeader header = sample_header();
  header.centre_axis.reset();
  header.obstacle.reset();
  const auto read = parse_header_payload(header_payload(header)).value();
  EXPECT_FALSE(read.centre_axis.has_value());
  EXPECT_FALSE(read.obstacle.has_value());
}

TEST(HeaderRecord, every_prefix_is_refused) {
  const std::string payload = header_payload(sample_header());
  for (std::size_t size = 0; size < payload.size(); ++size)
    EXPECT_FALSE(parse_header_payload(payload.substr(0, size)).has_value()) << size;
}

TEST(HeaderRecord, what_a_newer_minor_version_appends_is_ignored) {
  std::string payload = header_payload(with_row_widths()) + "news";
  payload[2] = 9;
  EXPECT_TRUE(parse_header_payload(payload).has_value());
}

TEST(HeaderRecord, positions_that_are_coded_otherwise_are_refused) {
  std::string payload = header_payload(sample_header());
  ++payload[4];
  EXPECT_FALSE(parse_header_payload(payload).has_value());
}

TEST(HeaderRecord, limited_edges_come_back_one_by_one) {
  for (const LimitedEdges edges : {LimitedEdges{}, LimitedEdges{.along = true},
                                   LimitedEdges{.across = true}, LimitedEdges{.diagonals = true}}) {
    RecordingHeader header = sample_header();
    header.limited_edges = edges;
    EXPECT_EQ(parse_header_payload(header_payload(header))->limited_edges, edges);
  }
}

RecordingHeader without_curve() {
  RecordingHeader header = sample_header();
  header.input_curve.resize(3, 0);
  return header;
}

// So many columns of a matrix, each of so many numbers.
std::string columns(std::uint32_t count, const std::string& numbers) {
  std::string bytes;
  put<std::uint32_t>(bytes, count);
  put_string(bytes, Compressor().compress(numbers));
  return bytes;
}

// What stands last in the header of a sample: the count of the marks, a byte for the part, and no
// widths of rows. Before it the count of the stages, before that the curve, and before that the
// limit of strain: a byte and a number.
constexpr std::size_t count_bytes = 4;
constexpr std::size_t limit_bytes = 9;
const std::size_t no_columns_bytes = columns(0, "").size();
const std::size_t marks_bytes = count_bytes + 1 + no_columns_bytes;

TEST(HeaderRecord, bits_of_edges_that_later_versions_limit_are_ignored) {
  std::string payload = header_payload(without_curve());
  payload[payload.size() - marks_bytes - count_bytes - no_columns_bytes - limit_bytes] = '\xFB';
  EXPECT_EQ(parse_header_payload(payload)->limited_edges, sample_header().limited_edges);
}

TEST(HeaderRecord, a_recording_need_not_tell_its_curve) {
  const auto read = parse_header_payload(header_payload(without_curve()));
  ASSERT_TRUE(read.has_value()) << read.error().sentence();
  EXPECT_EQ(read->input_curve.cols(), 0);
}

// In the place of the count of no points, and what is behind it the last curve that was written.
bool is_taken_with_curve_points(std::uint32_t count) {
  const std::string with_curve = header_payload(sample_header());
  const std::size_t count_at =
      header_payload(without_curve()).size() - marks_bytes - count_bytes - no_columns_bytes;
  std::string bytes;
  put<std::uint32_t>(bytes, count);
  return parse_header_payload(std::string(with_curve).replace(count_at, count_bytes, bytes))
      .has_value();
}

TEST(HeaderRecord, curve_points_that_are_not_there_are_refused) {
  EXPECT_TRUE(is_taken_with_curve_points(4));
  for (const std::uint32_t count : {1U, 3U, 5U, 1U << 20, (1U << 20) + 1, 0x80000000U, 0xFFFFFFFFU})
    EXPECT_FALSE(is_taken_with_curve_points(count)) << count;
}

TEST(HeaderRecord, a_curve_of_a_single_point_is_none) {
  std::string payload = header_payload(without_curve());
  const std::string rest = payload.substr(payload.size() - marks_bytes - count_bytes);
  payload.resize(payload.size() - rest.size() - no_columns_bytes);
  for (const std::uint32_t points : {2U, 1U}) {
    const std::size_t numbers = std::size_t{3} * points;
    std::string curve = columns(points, std::string(numbers * sizeof(float), '\0'));
    EXPECT_EQ(parse_header_payload(payload.append(curve).append(rest)).has_value(), points == 2);
    payload.resize(payload.size() - curve.size() - rest.size());
  }
}

TEST(HeaderRecord, stages_come_back_but_not_more_than_a_byte_counts) {
  RecordingHeader header = sample_header();
  header.stages = {"half knot", ""};
  EXPECT_EQ(parse_header_payload(header_payload(header))->stages, header.stages);
  header.stages.assign(255, "x");
  std::string payload = header_payload(header);
  EXPECT_EQ(parse_header_payload(payload)->stages.size(), 255U);
  const std::size_t last_at = payload.size() - marks_bytes - 5;
  payload.insert(last_at, payload.substr(last_at, 5));
  const std::size_t count_at = last_at - std::size_t{254} * 5 - count_bytes;
  payload[count_at + 1] = 1;
  payload[count_at] = 0;
  EXPECT_FALSE(parse_header_payload(payload).has_value());
}

TEST(HeaderRecord, marks_and_the_part_to_certify_come_back) {
  RecordingHeader header = sample_header();
  header.marks = {{"tip", 0.25}, {"", 1}};
  header.knot_between = KnotBetween{{0.75, 0.25}, "reef knot"};
  const std::string payload = header_payload(header);
  const auto read = parse_header_payload(payload).value();
  EXPECT_EQ(read.marks, header.marks);
  EXPECT_EQ(read.knot_between, header.knot_between);
  for (std::size_t size = payload.size() - 60; size < payload.size(); ++size)
    EXPECT_FALSE(parse_header_payload(payload.substr(0, size)).has_value()) << size;
}

TEST(HeaderRecord, places_beyond_the_ribbon_and_more_marks_than_can_be_are_refused) {
  const auto is_taken = [](const std::vector<RecordedMark>& marks,
                           const std::optional<KnotBetween>& between) {
    RecordingHeader header = sample_header();
    header.marks = marks;
    header.knot_between = between;
    return parse_header_payload(header_payload(header)).has_value();
  };
  EXPECT_TRUE(is_taken({{"tip", 1}}, KnotBetween{{0, 1}, ""}));
  EXPECT_FALSE(is_taken({{"tip", 1.5}}, {}));
  EXPECT_FALSE(is_taken({}, KnotBetween{{0, -0.5}, ""}));
  EXPECT_FALSE(is_taken({}, KnotBetween{{std::numeric_limits<double>::quiet_NaN(), 1}, ""}));
  EXPECT_TRUE(is_taken(std::vector<RecordedMark>(255, {"x", 0.5}), {}));
  std::string payload = header_payload(sample_header());
  const std::size_t marks_at = payload.size() - marks_bytes;
  payload[marks_at + 1] = 1;
  payload.insert(marks_at + count_bytes, std::string(256UL * (count_bytes + sizeof(double)), '\0'));
  EXPECT_FALSE(parse_header_payload(payload).has_value());
}

TEST(HeaderRecord, row_widths_come_back_or_are_none) {
  const RecordingHeader header = with_row_widths();
  const std::string payload = header_payload(header);
  EXPECT_EQ(parse_header_payload(payload)->row_widths_m, header.row_widths_m);
  const std::string even = header_payload(sample_header());
  EXPECT_TRUE(parse_header_payload(even)->row_widths_m.empty());
  for (std::size_t size = even.size(); size < payload.size(); ++size)
    EXPECT_FALSE(parse_header_payload(payload.substr(0, size)).has_value()) << size;
}

TEST(HeaderRecord, row_widths_that_are_none_or_not_of_the_ribbon_are_refused) {
  const auto is_taken_with_first = [](double width_m, double second_m) {
    RecordingHeader header = with_row_widths();
    header.row_widths_m[0] += width_m;
    header.row_widths_m[1] += second_m;
    return parse_header_payload(header_payload(header)).has_value();
  };
  const double first_m = with_row_widths().row_widths_m[0];
  EXPECT_TRUE(is_taken_with_first(0, 0));
  EXPECT_TRUE(is_taken_with_first(-first_m / 2, first_m / 2));
  EXPECT_FALSE(is_taken_with_first(-first_m, first_m)) << "a row without width";
  EXPECT_FALSE(is_taken_with_first(-2 * first_m, 2 * first_m));
  EXPECT_FALSE(is_taken_with_first(std::numeric_limits<double>::quiet_NaN(), 0));
  EXPECT_FALSE(is_taken_with_first(std::numeric_limits<double>::infinity(), 0));
  EXPECT_FALSE(is_taken_with_first(first_m / 2, 0)) << "another mean than the ribbon's width";
}

// The block says how many it holds; the grid, how many there must be.
TEST(HeaderRecord, more_or_fewer_row_widths_than_rows_are_refused) {
  const RecordingHeader header = with_row_widths();
  std::string before = header_payload(sample_header());
  before.resize(before.size() - no_columns_bytes);
  for (const int surplus : {-1, 0, 1}) {
    std::string widths;
    for (int row = 0; row < header.grid.along + surplus; ++row)
      put<float>(widths, static_cast<float>(header.ribbon_width_m * header.grid.along /
                                            (header.grid.along + surplus)));
    const auto count = static_cast<std::uint32_t>(header.grid.along + surplus);
    EXPECT_EQ(parse_header_payload(before + columns(count, widths)).has_value(), surplus == 0);
  }
}

TEST(HeaderRecord, an_older_major_version_is_refused_with_a_sentence) {
  std::string payload = header_payload(sample_header());
  payload[0] = 2;
  payload[2] = 4;
  EXPECT_EQ(
      refusal_of(parse_header_payload(payload)),
      "was written in format version 2.4 by tests 1.0, this program reads version 7; use that "
      "program, or record it again");
  EXPECT_EQ(refusal_of(parse_header_payload(payload.substr(0, 20))),
            "was written in format version 2.4, this program reads version 7; record it again");
  payload[0] = 1;
  EXPECT_EQ(refusal_of(parse_header_payload(payload)),
            "was written in format version 1.4, this program reads version 7; record it again")
      << "its header told other fields";
  RecordingHeader header = sample_header();
  header.writer.clear();
  EXPECT_EQ(refusal_of(parse_header_payload(header_payload(header).replace(0, 1, "\2"))),
            "was written in format version 2.0, this program reads version 7; record it again");
}

TEST(HeaderRecord, the_origin_comes_back) {
  RecordingHeader header = sample_header();
  header.origin = Origin{0xCAFE, "mother", 77, "time.step = 0.01\n"};
  EXPECT_EQ(parse_header_payload(header_payload(header))->origin, header.origin);
}

// Bytes 8 to 15 are the grid's counts.
std::string with_grid(std::uint32_t along, std::uint32_t across) {
  std::string counts;
  put<std::uint32_t>(counts, along);
  put<std::uint32_t>(counts, across);
  return header_payload(sample_header()).replace(8, 8, counts);
}

TEST(HeaderRecord, counts_that_lie_are_refused) {
  EXPECT_TRUE(parse_header_payload(with_grid(40, 6)).has_value());
  EXPECT_FALSE(parse_header_payload(with_grid(41, 6)).has_value());
  EXPECT_FALSE(parse_header_payload(with_grid(1, 240)).has_value());
  EXPECT_FALSE(parse_header_payload(with_grid(4096, 4096)).has_value());
  EXPECT_FALSE(parse_header_payload(with_grid(0xFFFFFFFF, 0xFFFFFFFF)).has_value());
  EXPECT_FALSE(parse_header_payload(with_grid(0x80000000, 2)).has_value());
  EXPECT_TRUE(is_recordable({4096, 4096}));
  EXPECT_FALSE(is_recordable({4097, 4096}));
}

// A point for each row of the ribbon with the most rows.
TEST(HeaderRecord, a_curve_may_have_as_many_points_as_a_ribbon_rows) {
  RecordingHeader header = sample_header();
  header.input_curve.setZero(3, 1 << 23);
  EXPECT_EQ(parse_header_payload(header_payload(header))->input_curve, header.input_curve);
}

bool is_taken_with(const std::function<void(RecordingHeader&)>& change) {
  RecordingHeader header = sample_header();
  change(header);
  return parse_header_payload(header_payload(header)).has_value();
}

TEST(HeaderRecord, triangles_of_missing_vertices_are_refused) {
  EXPECT_TRUE(is_taken_with([](auto& header) { header.obstacle->triangles(1, 3) = 5; }));
  EXPECT_FALSE(is_taken_with([](auto& header) { header.obstacle->triangles(1, 3) = 6; }));
  EXPECT_FALSE(is_taken_with([](auto& header) { header.obstacle->triangles(1, 3) = -1; }));
}

TEST(HeaderRecord, impossible_numbers_are_refused) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(is_taken_with([](auto& header) { header.frames_per_second = nan; }));
  for (const double size : {-1.0, 0.0, nan, infinity}) {
    EXPECT_FALSE(is_taken_with([=](auto& header) { header.ribbon_length_m = size; })) << size;
    EXPECT_FALSE(is_taken_with([=](auto& header) { header.ribbon_width_m = size; })) << size;
  }
  EXPECT_FALSE(is_taken_with([](auto& header) { header.uv(1, 5) = nan; }));
  EXPECT_FALSE(is_taken_with([](auto& header) { header.scene_name.clear(); }));
  for (const double step : {-1e-6, nan, 1e38})
    EXPECT_FALSE(is_taken_with([=](auto& header) { header.quantisation_step_m = step; })) << step;
  EXPECT_FALSE(is_taken_with([](auto& header) { header.max_position_error_m = -1e-5; }));
  EXPECT_FALSE(is_taken_with([](auto& header) { header.obstacle->vertices(0, 0) = infinity; }));
  for (const double gap : {-1e-9, nan, infinity})
    EXPECT_FALSE(is_taken_with([=](auto& header) { header.stated_gap_m = gap; })) << gap;
  for (const double limit : {-1e-9, nan, infinity})
    EXPECT_FALSE(is_taken_with([=](auto& header) { header.strain_limit = limit; })) << limit;
  EXPECT_FALSE(is_taken_with([](auto& header) { header.centre_axis->direction *= 1.01; }));
  EXPECT_FALSE(is_taken_with([](auto& header) { header.centre_axis->point_m[1] = nan; }));
  EXPECT_FALSE(is_taken_with([](auto& header) { header.input_curve(2, 3) = infinity; }));
}

}  // namespace ribbon::header_record_test
