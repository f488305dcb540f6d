#include "recorder/page/taken_away.h"

#include <vector>

#include "files/files.h"
#include "model/glb_writer.h"
#include "model/model.h"
#include "model/obj_text.h"
#include "playback/recording_reader.h"

namespace ribbon {

namespace {

// A recording with the model that its frames pose.
struct PosedRecording {
  RecordingReader reader;
  Model model;

  static Result<PosedRecording> open(const std::filesystem::path& recording) {
    auto reader = RecordingReader::open(recording);
    if (!reader) return tl::unexpected(reader.error());
    auto model = model_of_recording(reader->header(), {});
    if (!model) return tl::unexpected(model.error());
    return PosedRecording{*std::move(reader), *std::move(model)};
  }

  Result<void> pose(int frame) {
    Eigen::Matrix3Xf positions;
    return reader.read(frame, positions)
        .and_then([&] { return pose_ribbon(model, positions, frame + 1); })
        .map([](bool) {});
  }
};

std::vector<int> readable_frames(const RecordingReader& reader) {
  std::vector<int> frames;
  for (int frame = 0; frame < reader.frame_count(); ++frame)
    if (reader.readable(frame)) frames.push_back(frame);
  return frames;
}

Result<void> append(PosedRecording& posed, const std::vector<int>& frames, MotionWriter& writer) {
  for (const int frame : frames)
    if (auto appended = posed.pose(frame).and_then([&] { return writer.append(posed.model); });
        !appended)
      return appended;
  return writer.finish();
}

}  // namespace

Result<void> write_shape(const std::filesystem::path& recording, int frame,
                         const std::filesystem::path& file) {
  auto posed = PosedRecording::open(recording);
  if (!posed) return tl::unexpected(posed.error());
  const Model& model = posed->model;
  const auto library = std::filesystem::path(file).replace_extension(".mtl");
  return posed->pose(frame)
      .and_then([&] { return write_file(file, obj_text(model, library.filename().string())); })
      .and_then([&] { return write_file(library, material_library_text(model)); });
}

Result<void> write_motion(const std::filesystem::path& recording,
                          const std::filesystem::path& file) {
  auto posed = PosedRecording::open(recording);
  if (!posed) return tl::unexpected(posed.error());
  const std::vector<int> frames = readable_frames(posed->reader);
  if (frames.empty())
    return failure(recording.string(), "holds no frame that can be read", "tie it once more");
  if (auto first = posed->pose(frames.front()); !first) return first;
  const auto writer = new_glb_writer(file, posed->model, static_cast<int>(frames.size()));
  if (!writer) return tl::unexpected(writer.error());
  return append(*posed, frames, **writer);
}

Result<void> write_object(const TriangleMesh& object, const std::filesystem::path& file) {
  Model model;
  model.objects.push_back({.name = object.name,
                           .material = {"obstacle", {0, 0, 0}},
                           .positions = object.vertices,
                           .uv = Eigen::Matrix2Xf(2, 0),
                           .faces = object.triangles});
  return write_file(file, obj_text(model, ""));
}

}  // namespace ribbon
