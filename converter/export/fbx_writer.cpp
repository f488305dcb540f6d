#include "converter/export/fbx_writer.h"

#include <cassert>
#include <optional>
#include <utility>

#include "converter/export/fbx_arrays.h"
#include "converter/export/fbx_meshes.h"
#include "converter/export/fbx_motion.h"
#include "converter/export/fbx_record.h"
#include "converter/export/fbx_settings.h"
#include "files/pending_file.h"
#include "model/rate_warnings.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// Importers create a channel and a curve for each, and grow slow.
constexpr int many_frames = 1000;

// The bytes of a file as they become known. frames: of the motion; the first is the mesh itself.
class FbxFile {
 public:
  FbxFile(Model first, int frames) : first_(std::move(first)), frames_(frames) {
    add(fbx_settings(first_, frames_));
    bytes_.open("Objects");
    for (int object = 0; object < object_count(); ++object)
      add(fbx_mesh_records(first_, object, arrays_));
    if (frames_ == 1) return;
    shapes_.emplace(first_.objects.front(), arrays_);
    add(fbx_motion_records(first_, frames_));
  }

  // frame: from 1.
  void add_frame(int frame, const Model& model) {
    bytes_.add(shapes_->shape(frame, model.objects.front(), arrays_));
    add(fbx_channel_records(first_, frame, frames_, arrays_));
  }

  void end() {
    bytes_.close();
    bytes_.open("Connections");
    for (int object = 0; object < object_count(); ++object)
      add(fbx_mesh_connections(first_, object));
    if (frames_ > 1) add(fbx_motion_connections());
    for (int frame = 1; frame < frames_; ++frame) add(fbx_channel_connections(frame));
    bytes_.close();
    bytes_.add(fbx_takes(first_, frames_));
    bytes_.end();
  }

  // What has come since the last call, and what that one could not know yet.
  FbxBytes& bytes() { return bytes_; }

 private:
  [[nodiscard]] int object_count() const { return static_cast<int>(first_.objects.size()); }

  void add(const std::vector<FbxRecord>& records) {
    for (const FbxRecord& record : records) bytes_.add(record);
  }

  Model first_;
  int frames_;
  FbxBytes bytes_;
  FbxArrays arrays_;
  std::optional<FbxShapes> shapes_;  // where something moves
};

tl::unexpected<Error> too_long(const std::string& place) {
  return failure(place, "an .fbx holds at most 4 GB", "choose fewer frames with --frames");
}

class FbxWriter : public MotionWriter {
 public:
  FbxWriter(PendingFile file, std::filesystem::path path, const Model& model, int frames)
      : file_(std::move(file)), path_(std::move(path)), frames_(frames), content_(model, frames) {}

  Result<void> append(const Model& model) override {
    assert(frame_ < frames_);
    if (const int frame = frame_++; frame > 0) content_.add_frame(frame, model);
    return write();
  }

  Result<void> finish(Older older) override {
    assert(frame_ == frames_);
    content_.end();
    return write().and_then([&] { return file_.finish(older); });
  }

 private:
  Result<void> write() {
    FbxBytes& bytes = content_.bytes();
    if (!bytes.fits()) return too_long(path_.string());
    auto written = file_.append(bytes.take());
    for (const FbxBytes::LateEnd& late : bytes.take_late_ends())
      if (written) written = file_.overwrite(late.offset, late.bytes);
    return written;
  }

  PendingFile file_;
  std::filesystem::path path_;
  int frames_;
  int frame_ = 0;
  FbxFile content_;
};

}  // namespace

Result<std::unique_ptr<MotionWriter>> new_fbx_writer(const std::filesystem::path& path,
                                                     const Model& model, int frames) {
  auto file = PendingFile::create(path);
  if (!file) return tl::unexpected(file.error());
  return std::make_unique<FbxWriter>(std::move(*file), path, model, frames);
}

Result<std::string> fbx_bytes(const Model& model) {
  FbxFile file(model, 1);
  file.end();
  if (!file.bytes().fits()) return too_long("");
  return file.bytes().take();
}

std::string fbx_warning(const Model& model, int frames) {
  std::string warning;
  if (frames > many_frames)
    warning += filled_in("an .fbx of {} frames takes other programs minutes to open", frames);
  return joined_warnings(warning, whole_rate_warning(model, frames));
}

}  // namespace ribbon
