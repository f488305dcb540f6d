#include "recorder/page/taken_away.h"

#include <memory>
#include <vector>

#include "files/files.h"
#include "model/glb_writer.h"
#include "model/model.h"
#include "model/obj_text.h"
#include "playback/recording_reader.h"

namespace ribbon {

namespace {

Result<void> pose(RecordingReader& reader, int frame, Model& model) {
  Eigen::Matrix3Xf positions;
  return reader.read(frame, positions)
      .and_then([&] { return pose_ribbon(model, positions, frame + 1); })
      .map([](bool) {});
}

std::vector<int> readable_frames(const RecordingReader& reader) {
  std::vector<int> frames;
  for (int frame = 0; frame < reader.frame_count(); ++frame)
    if (reader.readable(frame)) frames.push_back(frame);
  return frames;
}

Result<void> append(RecordingReader& reader, const std::vector<int>& frames, Model& model,
                    MotionWriter& writer) {
  for (const int frame : frames)
    if (auto appended = pose(reader, frame, model).and_then([&] { return writer.append(model); });
        !appended)
      return appended;
  return writer.finish();
}

}  // namespace

Result<void> write_shape(const std::filesystem::path& recording, int frame,
                         const std::filesystem::path& file) {
  auto reader = RecordingReader::open(recording);
  if (!reader) return tl::unexpected(reader.error());
  auto model = model_of_recording(reader->header(), {});
  if (!model) return tl::unexpected(model.error());
  const auto library = std::filesystem::path(file).replace_extension(".mtl");
  return pose(*reader, frame, *model)
      .and_then([&] { return write_file(file, obj_text(*model, library.filename().string())); })
      .and_then([&] { return write_file(library, material_library_text(*model)); });
}

Result<void> write_motion(const std::filesystem::path& recording,
                          const std::filesystem::path& file) {
  auto reader = RecordingReader::open(recording);
  if (!reader) return tl::unexpected(reader.error());
  auto model = model_of_recording(reader->header(), {});
  if (!model) return tl::unexpected(model.error());
  const std::vector<int> frames = readable_frames(*reader);
  if (frames.empty())
    return failure(recording.string(), "holds no frame that can be read", "tie it once more");
  if (auto posed = pose(*reader, frames.front(), *model); !posed) return posed;
  const auto writer = new_glb_writer(file, *model, static_cast<int>(frames.size()));
  if (!writer) return tl::unexpected(writer.error());
  return append(*reader, frames, *model, **writer);
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
