#include "converter/whole_motion.h"

#include "commandline/progress.h"
#include "converter/companions.h"
#include "converter/motion_format.h"
#include "converter/output_names.h"
#include "files/files.h"
#include "model/obj_text.h"

namespace ribbon {

namespace {

// It is set; the recording has lost the frame; its ribbon cannot be made a solid.
enum class Pose { set, lost, no_solid };

Result<Pose> pose_at(RecordingReader& reader, int index, Model& model) {
  Eigen::Matrix3Xf positions;
  if (!reader.readable(index) || !reader.read(index, positions)) return Pose::lost;
  return pose_ribbon(model, positions, index + 1).map([](bool posed) {
    return posed ? Pose::set : Pose::no_solid;
  });
}

// Poses the model of `job` at the first of its frames that can be written.
Result<void> pose_at_start(const ConversionRequest& request, ConversionJob& job) {
  bool some_refused = false;
  for (const int index : job.frames) {
    if (request.interrupted()) return interrupted_conversion();
    const Result<Pose> pose = pose_at(job.reader, index, job.model);
    if (!pose) return tl::unexpected(pose.error());
    if (*pose == Pose::set) return {};
    some_refused |= *pose == Pose::no_solid;
  }
  return no_frames(job.model, some_refused);
}

void note(ConversionReport& report, Pose pose, int number) {
  ++(pose == Pose::set ? report.frames_written : report.frames_repeated);
  if (pose == Pose::lost) report.missing.push_back(number);
  if (pose == Pose::no_solid) report.refused.push_back(number);
}

Result<void> append_frames(RecordingReader& reader, const std::vector<int>& frames, Model& model,
                           MotionWriter& writer, const ConversionRequest& request,
                           ConversionReport& report) {
  ProgressLine progress("frame", static_cast<int>(frames.size()), request.progress);
  int done = 0;
  for (const int index : frames) {
    if (request.interrupted()) return interrupted_conversion();
    const Result<Pose> pose = pose_at(reader, index, model);
    if (!pose) return tl::unexpected(pose.error());
    note(report, *pose, index + 1);
    auto appended = writer.append(model);
    if (!appended) return appended;
    progress.update(++done);
  }
  return {};
}

// The mesh that the positions in `output` are for; its name is that with .obj. Returns its bytes.
Result<std::uint64_t> write_base(const Model& model, const std::filesystem::path& output,
                                 Older older) {
  const auto base = std::filesystem::path(output).replace_extension(".obj");
  const std::string mesh = obj_text(model, material_library_name(output.string()));
  return write_file(base, mesh, older).map([&] { return std::uint64_t{mesh.size()}; });
}

}  // namespace

Result<ConversionReport> write_whole_motion(const ConversionRequest& request, ConversionJob job) {
  const MotionFormat& format = *motion_format(request.output);
  if (auto posed = pose_at_start(request, job); !posed) return tl::unexpected(posed.error());
  const Model base = job.model;
  const auto companions = companions_of(request, job);
  const auto writer =
      format.new_writer(request.output, job.model, static_cast<int>(job.frames.size()));
  if (!writer) return tl::unexpected(writer.error());
  ConversionReport report;
  report.first_file = report.last_file = request.output;
  if (format.warning != nullptr)
    if (auto warning = format.warning(base, static_cast<int>(job.frames.size())); !warning.empty())
      report.remarks.push_back(std::move(warning));
  return append_frames(job.reader, job.frames, job.model, **writer, request, report)
      .and_then([&] { return (*writer)->finish(request.later()); })
      .and_then([&] {
        return write_companions(companions, std::filesystem::path(request.output).parent_path(),
                                request.later());
      })
      .and_then([&] {
        return format.deforms_base ? write_base(base, request.output, request.later())
                                   : Result<std::uint64_t>(0);
      })
      .map([&](std::uint64_t base_bytes) {
        report.bytes_written = std::filesystem::file_size(request.output) + base_bytes;
        for (const Companion& companion : companions)
          report.bytes_written += companion.content->size();
        report.damage = job.reader.damage();
        return report;
      });
}

}  // namespace ribbon
