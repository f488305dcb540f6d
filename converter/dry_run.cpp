#include "converter/dry_run.h"

#include "converter/conversion_job.h"
#include "converter/expected_size.h"
#include "converter/planned_files.h"
#include "text/number_text.h"

namespace ribbon {

Result<ConversionPlan> plan_conversion(const ConversionRequest& request) {
  auto job = open_job(request);
  if (!job) return tl::unexpected(job.error());
  const auto files = planned_files(request, *job);
  if (!files) return tl::unexpected(files.error());
  const auto size = expected_size(request, *job);
  if (!size) return tl::unexpected(size.error());
  ConversionPlan plan;
  plan.first_file = files->own.front();
  plan.last_file = is_one_file(job->format) ? plan.first_file : files->own.back();
  plan.files = static_cast<int>(files->own.size() + files->shared.size());
  plan.existing = existing_count(files->own);
  plan.bytes = size->bytes;
  for (const auto& shared : files->shared)
    plan.bytes += static_cast<double>(shared.content->size());
  plan.margin_bytes = size->margin_bytes;
  plan.processor_s = size->processor_s;
  return plan;
}

std::string plan_text(const ConversionPlan& plan) {
  std::string text =
      filled_in("would write {} {}, {:.3g} MB (± {:.2g})", plan.files,
                plan.files == 1 ? "file" : "files", plan.bytes / 1e6, plan.margin_bytes / 1e6);
  if (plan.processor_s > 0)
    text += filled_in(", by about {:.1f} s of processor time", plan.processor_s);
  text += ": " + plan.first_file.string();
  if (plan.last_file != plan.first_file) text += " ... " + plan.last_file.string();
  if (plan.existing > 0)
    text += filled_in("\n{} of them exist already and would be replaced only by --force",
                      plan.existing);
  return text;
}

}  // namespace ribbon
