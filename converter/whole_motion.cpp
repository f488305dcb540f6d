#include "converter/whole_motion.h"

#include "commandline/progress.h"
#include "converter/export/obj_text.h"
#include "converter/motion_format.h"
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
                           MotionWriter& writer, const ConversionRequest& request,
                           ConversionReport& report) {
  ProgressLine progress("frame", static_cast<int>(frames.size()), request.progress);
  for (const int index : frames) {
    if (request.interrupted()) return passing_failure("", "interrupted", "start again");
    const Result<bool> posed = pose_at(reader, index, model);
    if (!posed) return tl::unexpected(posed.error());
    if (!*posed) report.missing.push_back(index + 1);
    report.frames_written += *posed ? 1 : 0;
    auto appended = writer.append(model);
    if (!appended) return appended;
    progress.update(report.frames_written + static_cast<int>(report.missing.size()));
  }
  return {};
}

// The mesh that the positions in `output` are for; its name is that with .obj. Returns its bytes.
Result<std::uint64_t> write_base(const Model& model, const std::filesystem::path& output) {
  const std::string library = material_library_name(output.string());
  const auto base = std::filesystem::path(output).replace_extension(".obj");
  const std::string materials = material_library_text(model);
  const std::string mesh = obj_text(model, library);
  return write_file(output.parent_path() / library, materials)
      .and_then([&] { return write_file(base, mesh); })
      .map([&] { return std::uint64_t{materials.size() + mesh.size()}; });
}

}  // namespace

Result<ConversionReport> write_whole_motion(const ConversionRequest& request, ConversionJob job) {
  const MotionFormat& format = *motion_format(request.output);
  if (auto posed = pose_at_start(job.reader, job.frames, job.model); !posed)
    return tl::unexpected(posed.error());
  const Model base = job.model;
  const auto writer =
      format.new_writer(request.output, job.model, static_cast<int>(job.frames.size()));
  if (!writer) return tl::unexpected(writer.error());
  ConversionReport report;
  report.first_file = report.last_file = request.output;
  if (format.warning != nullptr)
    report.warning = format.warning(base, static_cast<int>(job.frames.size()));
  return append_frames(job.reader, job.frames, job.model, **writer, request, report)
      .and_then([&] { return (*writer)->finish(); })
      .and_then([&] {
        return format.deforms_base ? write_base(base, request.output) : Result<std::uint64_t>(0);
      })
      .map([&](std::uint64_t base_bytes) {
        report.bytes_written = std::filesystem::file_size(request.output) + base_bytes;
        report.damage = job.reader.damage();
        return report;
      });
}

}  // namespace ribbon
