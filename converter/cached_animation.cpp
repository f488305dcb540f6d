#include "converter/cached_animation.h"

#include "commandline/progress.h"
#include "converter/export/obj_text.h"
#include "converter/export/pc2_writer.h"
#include "converter/output_names.h"
#include "files/files.h"

namespace ribbon {

namespace {

// Poses `model` at the frame; false when the recording has lost it.
Result<bool> pose_at(RecordingReader& reader, int index, Model& model) {
  Eigen::Matrix3Xf positions;
  if (!reader.readable(index) || !reader.read(index, positions)) return false;
  return pose_ribbon(model, positions, index + 1).map([] { return true; });
}

// Poses `model` at the first of `frames` that can be read.
Result<void> pose_at_start(RecordingReader& reader, const std::vector<int>& frames, Model& model) {
  for (const int index : frames) {
    const Result<bool> posed = pose_at(reader, index, model);
    if (!posed) return tl::unexpected(posed.error());
    if (*posed) return {};
  }
  return failure("", "none of the frames can be read", "record it again");
}

Result<void> append_frames(RecordingReader& reader, const std::vector<int>& frames, Model& model,
                           MotionWriter& cache, const ConversionRequest& request,
                           ConversionReport& report) {
  ProgressLine progress("frame", static_cast<int>(frames.size()), request.quiet);
  for (const int index : frames) {
    if (request.interrupted()) return failure("", "interrupted", "start again");
    const Result<bool> posed = pose_at(reader, index, model);
    if (!posed) return tl::unexpected(posed.error());
    if (!*posed) report.missing.push_back(index + 1);
    report.frames_written += *posed ? 1 : 0;
    auto appended = cache.append(model);
    if (!appended) return appended;
    progress.update(report.frames_written + static_cast<int>(report.missing.size()));
  }
  return {};
}

// The mesh that the cache deforms; its name is the cache's with .obj.
Result<void> write_base(const Model& model, const std::filesystem::path& cache) {
  const std::string library = material_library_name(cache.string());
  const auto base = std::filesystem::path(cache).replace_extension(".obj");
  return write_file(cache.parent_path() / library, material_library_text(model)).and_then([&] {
    return write_file(base, obj_text(model, library));
  });
}

}  // namespace

Result<ConversionReport> write_cached_animation(const ConversionRequest& request,
                                                RecordingReader reader, Model model,
                                                const std::vector<int>& frames) {
  if (request.output.find('{') != std::string::npos)
    return failure(request.output, "a .pc2 file holds all frames", "leave {frame} out");
  if (auto posed = pose_at_start(reader, frames, model); !posed)
    return tl::unexpected(posed.error());
  const Model base = model;
  const auto cache = new_pc2_writer(request.output, model, static_cast<int>(frames.size()));
  if (!cache) return tl::unexpected(cache.error());
  ConversionReport report;
  report.first_file = report.last_file = request.output;
  return append_frames(reader, frames, model, **cache, request, report)
      .and_then([&] { return (*cache)->finish(); })
      .and_then([&] { return write_base(base, request.output); })
      .map([&] {
        report.bytes_written = std::filesystem::file_size(request.output);
        report.damage = reader.damage();
        return report;
      });
}

}  // namespace ribbon
