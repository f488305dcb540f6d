// recordings_for_readers FOLDER: writes small recordings of all kinds into the folder, and beside
// each NAME.rbn the frames that our own reader decodes from it: NAME.frames, of each frame that is
// readable its number, u32, and f32 x, y, z of each particle; and what strain is limited to:
// NAME.limits, of each kind of edge a u8, then f64, then the f64 width of each row; and the input
// curve: NAME.curve, f32 x, y, z of each point. recordings_for_readers FOLDER RECORDING...: does so
// for these.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "files/files.h"
#include "playback/recording_reader.h"
#include "recording/coding/bytes.h"
#include "recording/writer/recording_writer.h"
#include "result/demanded.h"

namespace ribbon {
namespace {

// What one of the recordings is like.
struct Kind {
  std::string name;
  RibbonGrid grid;
  double max_error_m = 0;
  int frames = 0;
  double largest_m = 1;
  bool rich = false;  // all that a header and the records beside frames can hold
  bool finished = true;
  bool damaged = false;  // here and there
  bool flat = false;     // z is -0
  bool tapered = false;  // rows differ in width
};

const std::vector<Kind> kinds = {
    {.name = "usual", .grid = {40, 16}, .max_error_m = 1e-5, .frames = 36, .rich = true},
    {.name = "killed", .grid = {21, 6}, .max_error_m = 1e-4, .frames = 19, .finished = false},
    {.name = "damaged", .grid = {21, 6}, .max_error_m = 1e-4, .frames = 60, .damaged = true},
    {.name = "odd", .grid = {33, 7}, .max_error_m = 1e-5, .frames = 20},
    {.name = "tapered", .grid = {30, 5}, .max_error_m = 1e-5, .frames = 20, .tapered = true},
    {.name = "narrow", .grid = {50, 2}, .max_error_m = 1e-5, .frames = 20},
    {.name = "short", .grid = {2, 9}, .max_error_m = 1e-6, .frames = 20},
    {.name = "coarse", .grid = {40, 16}, .max_error_m = 1e-2, .frames = 20},
    {.name = "exact", .grid = {40, 16}, .max_error_m = 0, .frames = 20},
    {.name = "flat", .grid = {12, 5}, .max_error_m = 0, .frames = 20, .flat = true},
    {.name = "beyond_the_reach",
     .grid = {20, 5},
     .max_error_m = 1e-5,
     .frames = 12,
     .largest_m = 1e9},
    {.name = "long", .grid = {3, 3}, .max_error_m = 1e-3, .frames = 530}};

RecordingHeader header_of(const Kind& kind) {
  RecordingHeader header;
  header.scene_name = kind.name;
  header.scene_text = "name = \"" + kind.name + "\"\n";
  header.writer = "recordings_for_readers";
  header.grid = kind.grid;
  header.uv.setRandom(2, kind.grid.particle_count());
  header.ribbon_length_m = 0.01 * (kind.grid.along - 1);
  header.ribbon_width_m = 0.006 * (kind.grid.across - 1);
  header.frames_per_second = 60;
  header.max_position_error_m = kind.max_error_m;
  header.quantisation_step_m = quantisation_step_m(kind.max_error_m, 2);
  for (int row = 0; row < kind.grid.along && kind.tapered; ++row)
    header.row_widths_m.push_back(static_cast<float>(
        header.ribbon_width_m * (0.5 + static_cast<double>(row) / (kind.grid.along - 1))));
  if (!kind.rich) return header;
  header.obstacle =
      TriangleMesh{"stone", Eigen::Matrix3Xf::Identity(3, 3), Eigen::Matrix3Xi{{0}, {1}, {2}}};
  header.stated_gap_m = 1e-3;
  header.centre_axis = CentreAxis{{1, 2, 3}, {0, 0.6, 0.8}};
  header.limited_edges = {.along = true, .diagonals = true};
  header.strain_limit = 0.125;
  header.input_curve.setRandom(3, 7);
  header.origin = Origin{77, "before", 2, "step = 0.01"};
  return header;
}

// A wave that goes over the ribbon, shaken from frame 10 on; every fifth frame of what reaches
// beyond the reach of quantised positions does so.
Eigen::Matrix3Xd positions_at(const Kind& kind, int frame) {
  std::mt19937 random(static_cast<unsigned>(frame));
  const double shake = frame < 10 ? 1e-6 : 1e-4;
  Eigen::Matrix3Xd positions(3, kind.grid.particle_count());
  for (int p = 0; p < positions.cols(); ++p) {
    const double phase = 0.2 * kind.grid.row(p) + 0.1 * kind.grid.column(p) - 0.3 * frame;
    positions.col(p) << 0.01 * kind.grid.row(p), 0.1 + 0.006 * kind.grid.column(p),
        0.05 * std::sin(phase);
    positions(2, p) += shake * (static_cast<double>(random()) / 0x1p32 - 0.5);
  }
  if (frame % 5 == 3) positions(0, 0) = kind.largest_m;
  if (kind.flat) positions.row(2).setConstant(-0.0);
  return positions;
}

void append(RecordingWriter& writer, const Kind& kind, int frame) {
  FrameNumbers numbers{.time_s = frame / 60.0,
                       .worst_strain = 0.001 * frame,
                       .penetrating_edges = 3,
                       .recovery_iterations = static_cast<std::uint32_t>(frame)};
  if (kind.rich)
    numbers.tightness =
        TightnessNumbers{.progress = 1, .contact = 0.01F * static_cast<float>(frame)};
  demanded(writer.append(numbers, positions_at(kind, frame)));
  if (!kind.rich || frame % 10 != 9) return;
  demanded(writer.append_checkpoint(3, "state " + std::to_string(frame)));
  demanded(writer.append_session({SessionReason::resumed, "program", "step = 0.02"}));
}

// Behind the header, which nothing can be read without.
void damage(const std::filesystem::path& path) {
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  for (const double share : {0.3, 0.55, 0.8}) {
    const auto at =
        static_cast<std::streamoff>(share * static_cast<double>(std::filesystem::file_size(path)));
    file.seekp(at);
    file.write("damage", 6);
  }
}

void write_recording(const std::filesystem::path& path, const Kind& kind) {
  RecordingWriter writer = demanded(RecordingWriter::create(path, header_of(kind)));
  for (int frame = 0; frame < kind.frames; ++frame) append(writer, kind, frame);
  if (kind.finished) demanded(writer.finish(RunEnding::tight));
  if (kind.damaged) damage(path);
}

void write_frames(const std::filesystem::path& recording, const std::filesystem::path& frames) {
  RecordingReader reader = demanded(RecordingReader::open(recording));
  reader.check();
  std::string bytes;
  Eigen::Matrix3Xf positions;
  for (int i = 0; i < reader.frame_count(); ++i) {
    if (!reader.read(i, positions)) continue;
    put<std::uint32_t>(bytes, static_cast<std::uint32_t>(i));
    bytes.append(reinterpret_cast<const char*>(positions.data()),
                 static_cast<std::size_t>(positions.size()) * sizeof(float));
  }
  demanded(write_file(frames, bytes));
}

void write_limits(const std::filesystem::path& recording, const std::filesystem::path& limits) {
  const RecordingHeader header = demanded(RecordingReader::open(recording)).header();
  std::string bytes;
  const LimitedEdges& edges = header.limited_edges;
  for (const bool limited : {edges.along, edges.across, edges.diagonals})
    put<std::uint8_t>(bytes, limited ? 1 : 0);
  put<double>(bytes, header.strain_limit);
  for (int row = 0; row < header.grid.along; ++row)
    put<double>(bytes, rest_size(header).row_width_m(row));
  demanded(write_file(limits, bytes));
}

void write_curve(const std::filesystem::path& recording, const std::filesystem::path& curve) {
  const RecordingHeader header = demanded(RecordingReader::open(recording)).header();
  std::string bytes;
  for (const float coordinate : header.input_curve.reshaped()) put<float>(bytes, coordinate);
  demanded(write_file(curve, bytes));
}

void write_for_readers(const std::filesystem::path& folder,
                       std::vector<std::filesystem::path> recordings) {
  std::filesystem::create_directories(folder);
  if (recordings.empty())
    for (const Kind& kind : kinds) {
      recordings.push_back(folder / (kind.name + ".rbn"));
      write_recording(recordings.back(), kind);
    }
  for (const std::filesystem::path& recording : recordings) {
    write_frames(recording, folder / (recording.stem().string() + ".frames"));
    write_limits(recording, folder / (recording.stem().string() + ".limits"));
    write_curve(recording, folder / (recording.stem().string() + ".curve"));
  }
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: recordings_for_readers FOLDER [RECORDING...]\n", stderr);
    return 2;
  }
  ribbon::write_for_readers(argv[1], {argv + 2, argv + argc});
}
