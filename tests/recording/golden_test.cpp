// Recordings of each format version, kept so that later programs are known to read them.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "playback/recording_reader.h"
#include "recording/coding/bytes.h"
#include "recording/coding/checksum.h"
#include "recording/sample_recording.h"
#include "recording/writer/recording_writer.h"

namespace ribbon::golden_test {

std::filesystem::path golden(const std::string& version) {
  return std::filesystem::path(RIBBON_GOLDEN_RECORDINGS) / ("v" + version + ".rbn");
}

const std::string this_version = "7.0";
constexpr int frames = 40;
constexpr RibbonGrid golden_grid{48, 6};

// A wave that runs obliquely over a ribbon, which slips in between. Made of sums, products and
// powers of two alone, so that it is the same everywhere.
Eigen::Matrix3Xd golden_positions(int frame) {
  const RibbonGrid grid = golden_grid;
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const int i = grid.row(p);
    const int j = grid.column(p);
    const double phase = (i * 5 + j * 7 + frame * 3) % 256 / 256.0;
    const double slip = (frame > 20 && i > 5) ? (i * 7 + j * 3 + frame * 5) % 11 / 8192.0 : 0;
    positions.col(p) << i / 16.0 + slip,
        phase * (1 - phase) / 4 + (i - 4) * (i - 4) * frame / 4096.0,
        j / 32.0 + frame * frame * i / 65536.0;
  }
  // Here single precision uses up nearly all of the bound.
  if (frame == 32) positions.row(1).array() += 600.0 + 1.0 / 65536;
  return positions;
}

// Between two stages there are frames without one, as of a run that nobody knows.
FrameNumbers golden_numbers(int frame) {
  FrameNumbers numbers = {frame / 64.0, frame / 1024.0, static_cast<std::uint32_t>(frame * frame),
                          static_cast<std::uint32_t>(frame)};
  const auto n = static_cast<float>(frame);
  numbers.tightness = {1 - n / 32, n / 256, 1 - n / 64, n / 128, 64 - n};
  numbers.stage = static_cast<std::uint8_t>(frame < 12 ? 1 : frame < 30 ? 0 : 2);
  return numbers;
}

RecordingHeader golden_header() {
  RecordingHeader header;
  header.scene_name = "golden";
  header.scene_text = "# two lines\nname = \"golden\"\n";
  header.writer = "ribbon-record 0.1.0";
  header.grid = golden_grid;
  header.uv.resize(2, golden_grid.particle_count());
  for (int p = 0; p < golden_grid.particle_count(); ++p)
    header.uv.col(p) << static_cast<float>(golden_grid.row(p)) / 64.0F,
        static_cast<float>(golden_grid.column(p)) / 8.0F;
  header.ribbon_length_m = 1.5;
  header.ribbon_width_m = 0.125;
  header.frames_per_second = 64;
  header.max_position_error_m = 0x1p-15;
  header.quantisation_step_m = 0x1p-15;
  TriangleMesh tetrahedron{"tetrahedron", Eigen::Matrix3Xf(3, 4), Eigen::Matrix3Xi(3, 4)};
  tetrahedron.vertices << 0, 1, 0, 0,  //
      0, 0, 1, 0,                      //
      0, 0, 0, 1;
  tetrahedron.triangles << 0, 0, 0, 1,  //
      2, 1, 3, 2,                       //
      1, 3, 2, 3;
  header.obstacle = tetrahedron;
  header.stated_gap_m = 0x1p-12;
  header.centre_axis = CentreAxis{{0.5, -0.25, 2}, {0, 0, -1}};
  header.limited_edges = {.along = true, .across = true, .diagonals = true};
  header.strain_limit = 0x1p-3;
  header.input_curve.resize(3, 3);
  header.input_curve << 0, 0.75F, 1.5F,  //
      0, 0.25F, 0,                       //
      0.125F, 0.125F, -0.125F;
  header.stages = {"half knot", "bow"};
  header.marks = {{"left", 0.25}, {"right", 0.75}};
  header.knot_between = KnotBetween{{0.25, 0.75}, "reef knot"};
  // Rows of three quarters and of five quarters of the width, in turn.
  for (int row = 0; row < header.grid.along; ++row)
    header.row_widths_m.push_back((row % 2 == 0 ? 0.75 : 1.25) * header.ribbon_width_m);
  header.origin = Origin{0x12345678, "golden mother", 17, "time.step = 0.5\n"};
  return header;
}

// Just after frame 25.
const Checkpoint golden_checkpoint{25, 1600, "state of the solver, state of the solver"};

// Before frame 30.
const Session golden_session{
    30, {SessionReason::extended, "ribbon-record 0.2.0", "time.duration = 2\n"}};

void write_golden(const std::filesystem::path& path) {
  std::filesystem::remove(path);
  auto writer = RecordingWriter::create(path, golden_header());
  ASSERT_TRUE(writer.has_value()) << writer.error().sentence();
  for (int frame = 0; frame < frames; ++frame) {
    if (frame == 30) {
      ASSERT_TRUE(writer->append_session(golden_session.note).has_value());
    }
    ASSERT_TRUE(writer->append(golden_numbers(frame), golden_positions(frame)).has_value());
    if (frame == 25) {
      ASSERT_TRUE(writer->append_checkpoint(golden_checkpoint.steps, golden_checkpoint.state));
    }
  }
  ASSERT_TRUE(writer->finish(RunEnding::tight).has_value());
}

std::string content(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TEST(GoldenRecording, it_is_there) {
  if (std::filesystem::exists(golden(this_version))) return;
  write_golden(golden(this_version));
  FAIL() << golden(this_version) << " was missing and has been written: look at it and commit it";
}

TEST(GoldenRecording, recording_it_again_gives_the_same_bytes) {
  const auto path = temporary_file("golden again.rbn");
  write_golden(path);
  EXPECT_TRUE(content(path) == content(golden(this_version)));
}

class GoldenVersions : public testing::TestWithParam<std::string> {};

TEST_P(GoldenVersions, it_is_read_as_it_was_written) {
  auto reader = RecordingReader::open(golden(GetParam()));
  ASSERT_TRUE(reader.has_value()) << reader.error().sentence();
  EXPECT_EQ(reader->header().scene_text, golden_header().scene_text);
  EXPECT_EQ(reader->header().obstacle->triangles, golden_header().obstacle->triangles);
  EXPECT_EQ(reader->header().uv, golden_header().uv);
  ASSERT_EQ(reader->frame_count(), frames);
  EXPECT_TRUE(reader->finished());
  EXPECT_EQ(reader->ending(), RunEnding::tight);
  EXPECT_EQ(reader->header().stated_gap_m, 0x1p-12);
  EXPECT_EQ(reader->header().centre_axis->point_m, Eigen::Vector3d(0.5, -0.25, 2));
  EXPECT_EQ(reader->header().origin, golden_header().origin);
  EXPECT_TRUE(reader->header().limited_edges.any());
  EXPECT_EQ(reader->header().strain_limit, 0x1p-3);
  EXPECT_EQ(reader->header().input_curve, golden_header().input_curve);
  EXPECT_EQ(reader->header().stages, golden_header().stages);
  EXPECT_EQ(reader->header().marks, golden_header().marks);
  EXPECT_EQ(reader->header().knot_between, golden_header().knot_between);
  EXPECT_EQ(reader->header().row_widths_m, golden_header().row_widths_m);
  EXPECT_EQ(reader->checkpoints(), std::vector<std::uint32_t>{25});
  EXPECT_EQ(reader->read_checkpoint(25).value(), golden_checkpoint);
  EXPECT_EQ(reader->sessions(), std::vector<Session>{golden_session});
  for (int frame = 0; frame < frames; ++frame) {
    EXPECT_EQ(reader->numbers(frame), golden_numbers(frame));
    Eigen::Matrix3Xf positions;
    ASSERT_TRUE(reader->read(frame, positions).has_value());
    EXPECT_LE((positions.cast<double>() - golden_positions(frame)).cwiseAbs().maxCoeff(), 0x1p-15);
  }
  reader->check();
  EXPECT_EQ(reader->ending(), RunEnding::tight) << "as its records tell, not only its directory";
  EXPECT_EQ(reader->numbers(7), golden_numbers(7));
}

TEST_P(GoldenVersions, every_bit_of_its_positions_is_known) {
  auto reader = RecordingReader::open(golden(GetParam()));
  ASSERT_TRUE(reader.has_value()) << reader.error().sentence();
  std::string bytes;
  Eigen::Matrix3Xf positions;
  for (int frame = 0; frame < frames; ++frame) {
    ASSERT_TRUE(reader->read(frame, positions).has_value());
    for (const float coordinate : positions.reshaped()) put<float>(bytes, coordinate);
  }

  EXPECT_EQ(checksum(bytes), 0xEEB48FBBU);
}

INSTANTIATE_TEST_SUITE_P(Versions, GoldenVersions, testing::Values("7.0"), [](const auto& version) {
  return "v" + version.param.substr(0, 1) + "_" + version.param.substr(2);
});

}  // namespace ribbon::golden_test
