#include "converter/dry_run.h"

#include <chrono>

#include "converter/conversion_job.h"
#include "converter/encode_model.h"
#include "converter/motion_format.h"
#include "converter/planned_files.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t bytes_of_numbers = 80;  // a line of CSV, about

// Poses the model at the first frame that can be read.
Result<void> pose_at_first(ConversionJob& job) {
  Eigen::Matrix3Xf positions;
  for (const int index : job.frames)
    if (job.reader.readable(index) && job.reader.read(index, positions))
      return pose_ribbon(job.model, positions, index + 1);
  return failure("", "none of the frames can be read", "record it again");
}

struct Cost {
  std::uint64_t bytes = 0;
  double seconds = 0;
};

// Of one frame in the file, or the obstacle alone.
Result<std::uint64_t> encoded_bytes(const ConversionJob& job, const std::string& output) {
  if (job.format == OutputFormat::numbers) return bytes_of_numbers;
  if (job.format == OutputFormat::recording)
    return job.reader.file_bytes() / static_cast<std::uint64_t>(job.reader.frame_count());
  if (job.format == OutputFormat::whole_motion)
    return motion_format(output)->bytes_of_pose(job.model);
  return encode_model(job.format, job.model, "name.mtl").map([](const std::string& bytes) {
    return static_cast<std::uint64_t>(bytes.size());
  });
}

// Of reading and encoding one frame, or the obstacle alone.
Result<Cost> cost_of_one(ConversionJob& job, const ConversionRequest& request) {
  const auto start = Clock::now();
  if (request.model.with_ribbon && job.format != OutputFormat::numbers)
    if (auto posed = pose_at_first(job); !posed) return tl::unexpected(posed.error());
  return encoded_bytes(job, request.output).map([&](std::uint64_t bytes) {
    return Cost{bytes, std::chrono::duration<double>(Clock::now() - start).count()};
  });
}

}  // namespace

Result<ConversionPlan> plan_conversion(const ConversionRequest& request) {
  auto job = open_job(request);
  if (!job) return tl::unexpected(job.error());
  const auto files = planned_files(request, *job);
  if (!files) return tl::unexpected(files.error());
  const bool moves = request.model.with_ribbon;
  const auto one = cost_of_one(*job, request);
  if (!one) return tl::unexpected(one.error());
  const std::size_t frames = moves ? job->frames.size() : 1;
  ConversionPlan plan;
  plan.first_file = files->own.front();
  plan.last_file = is_one_file(job->format) ? plan.first_file : files->own.back();
  plan.files = static_cast<int>(files->own.size() + files->libraries.size());
  plan.existing = existing_count(files->own);
  plan.bytes = frames * one->bytes;
  plan.processor_s = static_cast<double>(frames) * one->seconds;
  return plan;
}

std::string plan_text(const ConversionPlan& plan) {
  std::string text =
      filled_in("would write {} {}, about {:.1f} MB, by about {:.1f} s of processor time: {}",
                plan.files, plan.files == 1 ? "file" : "files",
                static_cast<double>(plan.bytes) / 1e6, plan.processor_s, plan.first_file.string());
  if (plan.last_file != plan.first_file) text += " ... " + plan.last_file.string();
  if (plan.existing > 0)
    text += filled_in("\n{} of them exist already and would be replaced only by --force",
                      plan.existing);
  return text;
}

}  // namespace ribbon
