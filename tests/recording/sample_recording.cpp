#include "recording/sample_recording.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ribbon {

namespace {

TriangleMesh octahedron() {
  TriangleMesh mesh{"stone", Eigen::Matrix3Xf(3, 6), Eigen::Matrix3Xi(3, 8)};
  mesh.vertices << 1, -1, 0, 0, 0, 0,  //
      0, 0, 1, -1, 0, 0,               //
      0, 0, 0, 0, 1, -1;
  mesh.vertices *= 0.2F;
  mesh.triangles << 0, 2, 1, 3, 2, 1, 3, 0,  //
      2, 1, 3, 0, 0, 2, 1, 3,                //
      4, 4, 4, 4, 5, 5, 5, 5;
  return mesh;
}

}  // namespace

RecordingHeader sample_header() {
  RecordingHeader header;
  header.scene_name = "sample";
  header.scene_text = "name = \"sample\"\n";
  header.writer = "tests 1.0";
  header.grid = {40, 6};
  header.uv.resize(2, header.grid.particle_count());
  for (int p = 0; p < header.grid.particle_count(); ++p)
    header.uv.col(p) << static_cast<float>(header.grid.row(p)) / 39.0F,
        static_cast<float>(header.grid.column(p)) / 5.0F;
  header.ribbon_length_m = 1;
  header.ribbon_width_m = 0.1;
  header.frames_per_second = 50;
  header.max_position_error_m = 1e-5;
  header.quantisation_step_m = quantisation_step_m(header.max_position_error_m, 1);
  header.obstacle = octahedron();
  header.stated_gap_m = 1e-4;
  header.centre_axis = CentreAxis{{0, 0.5, 0}, {0, 0.6, 0.8}};
  header.limited_edges = {.along = true, .across = true};
  header.strain_limit = 0.25;
  header.input_curve.resize(3, 4);
  header.input_curve << -0.5F, -0.125F, 0.25F, 0.5F,  //
      0.25F, 0.375F, 0.375F, 0.25F,                   //
      0, 0.125F, -0.125F, 0;
  return header;
}

RecordingHeader sample_header(const RibbonGrid& grid) {
  RecordingHeader header = sample_header();
  header.grid = grid;
  header.uv = Eigen::Matrix2Xf::Zero(2, grid.particle_count());
  header.obstacle.reset();
  return header;
}

Eigen::Matrix3Xd sample_positions(int frame) {
  const RibbonGrid grid = sample_header().grid;
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  const double turns = 0.02 * frame;
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double along = grid.row(p) / 39.0 - 0.5;
    const double across = 0.1 * (grid.column(p) / 5.0 - 0.5);
    const double angle = 6.283185307179586 * turns * along;
    positions.col(p) << along, 0.3 + across * std::sin(angle), across * std::cos(angle);
  }
  return positions;
}

FrameNumbers sample_numbers(int frame) {
  return {frame / 50.0, 0.001 * frame, static_cast<std::uint32_t>(frame % 3),
          static_cast<std::uint32_t>(2 * frame)};
}

void append_sample_frames(RecordingWriter& writer, int begin, int end) {
  for (int frame = begin; frame < end; ++frame)
    ASSERT_TRUE(writer.append(sample_numbers(frame), sample_positions(frame)).has_value());
}

void write_recording(const std::filesystem::path& path, const RecordingHeader& header,
                     const std::vector<Eigen::Matrix3Xd>& frames, Ending ending) {
  auto writer = RecordingWriter::create(path, header);
  ASSERT_TRUE(writer.has_value()) << writer.error().sentence();
  for (int frame = 0; frame < static_cast<int>(frames.size()); ++frame) {
    const auto appended = writer->append(sample_numbers(frame), frames[frame]);
    ASSERT_TRUE(appended.has_value()) << appended.error().sentence();
  }
  if (ending == Ending::killed) return;
  const auto finished = writer->finish();
  ASSERT_TRUE(finished.has_value()) << finished.error().sentence();
}

void write_sample_recording(const std::filesystem::path& path, int frames, Ending ending) {
  std::filesystem::remove(path);  // one without frames would not take its place
  auto writer = RecordingWriter::create(path, sample_header()).value();
  append_sample_frames(writer, 0, frames);
  if (ending == Ending::killed) return;
  ASSERT_TRUE(writer.finish().has_value());
}

}  // namespace ribbon
