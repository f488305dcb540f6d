#include "player/measure/particle_measure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "files/files.h"
#include "files/flipped.h"
#include "geometry/solids.h"
#include "parallel/any_threads.h"
#include "recording/sample_recording.h"

namespace ribbon::particle_measure_test {

// Recorded coordinates are off by 0.01 mm at most.
constexpr double speed_error = 4 * 1e-5 * 50;

// The sample's ribbon at rest, in the plane y = 0.
Eigen::Matrix3Xd flat() {
  const RecordingHeader header = sample_header();
  Eigen::Matrix3Xd positions(3, header.grid.particle_count());
  for (int p = 0; p < header.grid.particle_count(); ++p)
    positions.col(p) << header.grid.row(p) / 39.0, 0, 0.1 * header.grid.column(p) / 5.0;
  return positions;
}

Eigen::Matrix3Xd moved(double along_m, double up_m) {
  return flat().colwise() + Eigen::Vector3d(along_m, up_m, 0);
}

class ParticleMeasureTest : public TestInFolder {
 protected:
  RecordingReader recorded(const std::vector<Eigen::Matrix3Xd>& frames,
                           const RecordingHeader& header = sample_header()) {
    write_recording(folder_ / "knot.rbn", header, frames);
    return RecordingReader::open(folder_ / "knot.rbn").value();
  }

  static std::vector<float> values(RecordingReader& reader, ParticleMeasure& measure, int index) {
    Eigen::Matrix3Xf positions;
    EXPECT_TRUE(reader.read(index, positions));
    return measure.values(index, positions);
  }
};

void expect_all(const std::vector<float>& values, double expected, double tolerance) {
  EXPECT_EQ(values.size(), 240U);
  for (const float value : values) EXPECT_NEAR(value, expected, tolerance);
}

TEST_F(ParticleMeasureTest, a_ribbon_stretched_by_five_percent_shows_five_percent) {
  Eigen::Matrix3Xd stretched = flat();
  stretched.row(0) *= 1.05;
  RecordingReader reader = recorded({flat(), stretched});
  ParticleMeasure strain(reader, Quantity::strain, 0);
  expect_all(values(reader, strain, 0), 0, 0.002);
  expect_all(values(reader, strain, 1), 0.05, 0.002);
}

TEST_F(ParticleMeasureTest, strain_is_that_of_the_limited_edges_and_of_all_where_none_is) {
  Eigen::Matrix3Xd sheared = flat();
  sheared.row(0) += 0.5 * sheared.row(2);  // changes diagonals most, and the edges across
  RecordingHeader header = sample_header();
  header.strain_limit = 0;
  header.limited_edges = {.along = true};
  RecordingReader along = recorded({sheared}, header);
  ParticleMeasure of_along(along, Quantity::strain, 0);
  expect_all(values(along, of_along, 0), 0, 0.002);
  header.limited_edges = {};
  RecordingReader none = recorded({sheared}, header);
  ParticleMeasure of_all(none, Quantity::strain, 0);
  const double along_m = 1 / 39.0;
  const double long_diagonal = std::hypot(along_m + 0.01, 0.02) / std::hypot(along_m, 0.02) - 1;
  const auto strains = values(none, of_all, 0);
  EXPECT_NEAR(strains[120], long_diagonal, 0.002);
}

TEST_F(ParticleMeasureTest, a_ribbon_that_is_moved_has_its_speed_and_begins_at_rest) {
  RecordingReader reader = recorded({flat(), moved(0.002, 0), moved(0.002, 0.004)});
  ParticleMeasure speed(reader, Quantity::speed, 0);
  expect_all(values(reader, speed, 0), 0, 0);
  expect_all(values(reader, speed, 1), 0.1, speed_error);
  expect_all(values(reader, speed, 2), 0.2, speed_error);
}

TEST_F(ParticleMeasureTest, speed_does_not_depend_on_what_was_measured_before) {
  RecordingReader reader = recorded({flat(), moved(0.002, 0), moved(0.002, 0.004)});
  ParticleMeasure fresh(reader, Quantity::speed, 0);
  const auto expected = values(reader, fresh, 2);
  ParticleMeasure used(reader, Quantity::speed, 0);
  values(reader, used, 2);
  values(reader, used, 0);
  EXPECT_EQ(values(reader, used, 2), expected);
}

TEST_F(ParticleMeasureTest, speed_bridges_lost_frames) {
  std::vector<Eigen::Matrix3Xd> frames;
  frames.reserve(40);
  for (int frame = 0; frame < 40; ++frame) frames.push_back(moved(0.002 * frame, 0));
  recorded(frames);
  const auto path = folder_ / "knot.rbn";
  const std::string bytes = read_file(path).value();
  ASSERT_TRUE(write_file(path, flipped(bytes, bytes.size() / 2)));
  RecordingReader reader = RecordingReader::open(path).value();
  reader.check();
  ParticleMeasure speed(reader, Quantity::speed, 0);
  int bridged = 0;
  for (int index = 1; index < reader.frame_count(); ++index) {
    if (!reader.readable(index)) continue;
    bridged += reader.readable(index - 1) ? 0 : 1;
    expect_all(values(reader, speed, index), 0.1, speed_error);
  }
  EXPECT_GT(bridged, 0);
}

// The second half of the ribbon lies 1 mm above the first, 3 mm above a table.
class Folded : public ParticleMeasureTest {
 protected:
  RecordingReader folded() {
    RecordingHeader header = sample_header();
    header.obstacle =
        quad_mesh({-1, -0.003F, -1}, {-1, -0.003F, 1}, {1, -0.003F, 1}, {1, -0.003F, -1});
    Eigen::Matrix3Xd positions = flat();
    for (int p = 120; p < 240; ++p)
      positions.col(p) << positions(0, 239 - p), 0.001, positions(2, p);
    return recorded({positions}, header);
  }

  RecordingReader reader_ = folded();
};

TEST_F(Folded, gaps_are_those_of_the_layers_and_of_the_table) {
  ParticleMeasure gap(reader_, Quantity::gap, 0.01);
  expect_all(values(reader_, gap, 0), 0.001, 4e-5);
}

TEST_F(Folded, beyond_reach_there_is_nothing) {
  ParticleMeasure gap(reader_, Quantity::gap, 0.0005);
  for (const float value : values(reader_, gap, 0))
    EXPECT_EQ(value, std::numeric_limits<float>::infinity());
}

TEST_F(Folded, contact_is_with_what_is_nearer) {
  ParticleMeasure contact(reader_, Quantity::contact, 0.002);
  expect_all(values(reader_, contact, 0), ParticleMeasure::touches_ribbon, 0);
  ParticleMeasure nothing(reader_, Quantity::contact, 0.0005);
  expect_all(values(reader_, nothing, 0), ParticleMeasure::touches_nothing, 0);
}

TEST_F(ParticleMeasureTest, on_a_table_a_flat_ribbon_touches_the_obstacle) {
  RecordingHeader header = sample_header();
  header.obstacle =
      quad_mesh({-1, -0.003F, -1}, {-1, -0.003F, 1}, {2, -0.003F, 1}, {2, -0.003F, -1});
  RecordingReader reader = recorded({flat()}, header);
  ParticleMeasure contact(reader, Quantity::contact, 0.0035);
  expect_all(values(reader, contact, 0), ParticleMeasure::touches_obstacle, 0);
}

TEST_F(Folded, the_same_for_any_number_of_threads) {
  ParticleMeasure gap(reader_, Quantity::gap, 0.01);
  same_for_any_threads([&] { return values(reader_, gap, 0); });
}

TEST_F(Folded, where_a_place_is_no_number_nothing_is_near) {
  ParticleMeasure gap(reader_, Quantity::gap, 0.01);
  Eigen::Matrix3Xf positions = flat().cast<float>();
  positions(1, 7) = std::numeric_limits<float>::quiet_NaN();
  for (const float value : gap.values(0, positions))
    EXPECT_EQ(value, std::numeric_limits<float>::infinity());
}

}  // namespace ribbon::particle_measure_test
