#include "converter/dry_run.h"

#include <chrono>

#include "converter/conversion_job.h"
#include "converter/encode_model.h"
#include "converter/planned_files.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

using Clock = std::chrono::steady_clock;

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

// Of reading and encoding one frame, or the obstacle alone. A cache takes positions alone.
Result<Cost> cost_of_one(ConversionJob& job, bool moves) {
  const auto start = Clock::now();
  if (moves)
    if (auto posed = pose_at_first(job); !posed) return tl::unexpected(posed.error());
  std::uint64_t bytes = job.model.objects.front().positions.size() * sizeof(float);
  if (job.format == OutputFormat::recording) {
    bytes = job.reader.file_bytes() / static_cast<std::uint64_t>(job.reader.frame_count());
  } else if (job.format != OutputFormat::pc2) {
    const auto encoded = encode_model(job.format, job.model, "name.mtl");
    if (!encoded) return tl::unexpected(encoded.error());
    bytes = encoded->size();
  }
  return Cost{bytes, std::chrono::duration<double>(Clock::now() - start).count()};
}

}  // namespace

Result<ConversionPlan> plan_conversion(const ConversionRequest& request) {
  auto job = open_job(request);
  if (!job) return tl::unexpected(job.error());
  const auto files = planned_files(request, *job);
  if (!files) return tl::unexpected(files.error());
  const bool moves = request.model.with_ribbon;
  const auto one = cost_of_one(*job, moves);
  if (!one) return tl::unexpected(one.error());
  const std::size_t frames = moves ? job->frames.size() : 1;
  ConversionPlan plan;
  plan.first_file = files->own.front();
  plan.last_file = job->format == OutputFormat::pc2 ? plan.first_file : files->own.back();
  plan.files = static_cast<int>(files->own.size() + files->libraries.size());
  plan.existing = existing_count(files->own);
  plan.bytes = frames * one->bytes;
  plan.processor_s = static_cast<double>(frames) * one->seconds;
  return plan;
}

std::string plan_text(const ConversionPlan& plan) {
  std::string text = filled_in(
      "would write {} files, about {:.1f} MB, by about {:.1f} s of processor time: {}", plan.files,
      static_cast<double>(plan.bytes) / 1e6, plan.processor_s, plan.first_file.string());
  if (plan.last_file != plan.first_file) text += " ... " + plan.last_file.string();
  if (plan.existing > 0)
    text += filled_in("\n{} of them exist already and would be replaced only by --force",
                      plan.existing);
  return text;
}

}  // namespace ribbon
