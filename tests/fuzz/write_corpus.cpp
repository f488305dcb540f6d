// fuzz_corpus FOLDER: writes what the fuzz targets begin with into folders of their names; run it
// when the format has changed. What it wrote for this version is kept in tests/fuzz/corpus.
#include <cstdio>
#include <filesystem>
#include <string>

#include "files/files.h"
#include "fuzz/reference_frames.h"
#include "recording/codec/position_encoder.h"
#include "recording/writer/recording_writer.h"
#include "result/demanded.h"

namespace ribbon {
namespace {

// Bytes as FuzzInput takes them.
std::string bytes(std::initializer_list<int> values) {
  std::string result;
  for (const int value : values) result.push_back(static_cast<char>(value));
  return result;
}

template <class Number>
std::string bytes_of(Number number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

void write(const std::filesystem::path& file, const std::string& content) {
  demanded(write_file(file, content));
}

// Frames as round_trip.cpp reads them: grid, bound, reach; then of each frame what changes and,
// behind what that asks for, its reference.
void write_round_trips(const std::filesystem::path& folder) {
  const std::string bend = bytes({1, 20});
  const std::string shake = bytes({8, 7, 12});
  const std::string move = bytes({2}) + bytes_of(0.001F);
  const std::string three = bytes({3, 2});
  const std::string wave = bend + bytes({0}) + move + bytes({1}) + move + bytes({2});
  write(folder / "smooth", bytes({38, 14, 5, 0}) + wave + move + three);
  write(folder / "exact", bytes({38, 14, 0, 0}) + wave + shake + three);
  write(folder / "noise", bytes({21, 5, 4, 0}) + wave + shake + three + shake + bytes({0}));
  write(folder / "narrow", bytes({60, 0, 5, 0}) + wave + move + three);
  write(folder / "fine", bytes({9, 9, 2, 0}) + wave + shake + three);
  const auto with_one = [](double value) {
    return bytes({16, 0, 3, 0}) + bytes_of(value) + bytes({1});
  };
  write(folder / "not_a_number", bytes({5, 5, 5, 0}) + bend + bytes({0}) + with_one(0.0 / 0.0));
  write(folder / "huge", bytes({5, 5, 5, 0}) + bend + bytes({0}) + with_one(1e300));
  write(folder / "large", bytes({5, 5, 7, 0}) + bend + bytes({0}) + with_one(1e9));
  write(folder / "denormal", bytes({5, 5, 0, 0}) + bend + bytes({0}) + with_one(1e-310));
}

// A frame, as hostile_geometry.cpp reads it.
std::string geometry(const RibbonGrid& grid, bool uniform, bool is_predicted) {
  const CodecParameters parameters = parameters_for(grid, uniform);
  const QuantisedFrame before = reference_frame(parameters);
  const EncodedFrame encoded = PositionEncoder(parameters, reference_bound_m)
                                   .encode(wave(grid, 1), is_predicted ? &before : nullptr)
                                   .value();
  return bytes({grid.along - 2, grid.across - 2, uniform ? 1 : 0,
                static_cast<int>(encoded.encoding), is_predicted ? 1 : 0}) +
         encoded.geometry;
}

void write_geometries(const std::filesystem::path& folder) {
  for (const bool uniform : {false, true})
    for (const bool is_predicted : {false, true})
      write(folder / (std::string(uniform ? "quantised" : "exact") + (is_predicted ? "_1" : "_0")),
            geometry({17, 6}, uniform, is_predicted));
}

void write_meshes(const std::filesystem::path& folder) {
  write(folder / "polygons",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
  write(folder / "facets",
        "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nendsolid s\n");
  write(folder / "faces", "o a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf -1 -2 -3\n");
}

RecordingHeader header_of(double max_error_m) {
  RecordingHeader header;
  header.scene_name = "fuzz";
  header.scene_text = "#";
  header.writer = "fuzz_corpus";
  header.grid = {5, 3};
  header.uv.setZero(2, header.grid.particle_count());
  header.ribbon_length_m = 0.05;
  header.ribbon_width_m = 0.02;
  header.frames_per_second = 60;
  header.max_position_error_m = max_error_m;
  header.quantisation_step_m = quantisation_step_m(max_error_m, 1);
  return header;
}

// Everything that a header can hold.
RecordingHeader rich_header() {
  RecordingHeader header = header_of(1e-4);
  header.obstacle =
      TriangleMesh{"stone", Eigen::Matrix3Xf::Identity(3, 3), Eigen::Matrix3Xi{{0}, {1}, {2}}};
  header.stated_gap_m = 1e-3;
  header.centre_axis = CentreAxis{{0, 0, 0}, {0, 0, 1}};
  header.limited_edges = {.along = true, .across = true, .diagonals = true};
  header.strain_limit = 0.1;
  header.input_curve = Eigen::Matrix3Xf::Identity(3, 5);
  header.origin = Origin{1, "before", 2, "step = 0.01"};
  return header;
}

void append(RecordingWriter& writer, int frame, bool with_tightness) {
  FrameNumbers numbers{.time_s = frame / 60.0};
  if (with_tightness) numbers.tightness = TightnessNumbers{.progress = 1};
  demanded(writer.append(numbers, wave(writer.header().grid, frame)));
}

void write_recordings(const std::filesystem::path& folder) {
  RecordingWriter finished =
      demanded(RecordingWriter::create(folder / "finished", header_of(1e-4)));
  for (int frame = 0; frame < 4; ++frame) append(finished, frame, false);
  demanded(finished.finish(RunEnding::tight));
  RecordingWriter rich = demanded(RecordingWriter::create(folder / "rich", rich_header()));
  for (int frame = 0; frame < 3; ++frame) append(rich, frame, true);
  demanded(rich.append_checkpoint(7, "state"));
  demanded(rich.append_session(SessionNote{}));
  append(rich, 3, true);
  demanded(rich.finish(RunEnding::duration));
  RecordingWriter exact =
      demanded(RecordingWriter::create(folder / "exact_and_killed", header_of(0)));
  for (int frame = 0; frame < 18; ++frame) append(exact, frame, false);
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: fuzz_corpus FOLDER\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  ribbon::write_round_trips(folder / "round_trip");
  ribbon::write_geometries(folder / "hostile_geometry");
  ribbon::write_recordings(folder / "recording_file");
  ribbon::write_meshes(folder / "mesh_file");
  return 0;
}
