#include "converter/conversion.h"

#include <memory>
#include <utility>

#include "converter/conversion_job.h"
#include "converter/excerpt.h"
#include "converter/frame_sequence.h"
#include "converter/number_table.h"
#include "converter/planned_files.h"
#include "converter/remarks.h"
#include "converter/still_life.h"
#include "converter/whole_motion.h"
#include "files/files.h"
#include "model/solid_ribbon.h"

namespace ribbon {

namespace {

Result<ConversionReport> write_job(const ConversionRequest& request, ConversionJob job) {
  if (job.format == OutputFormat::recording) return write_excerpt(request, std::move(job));
  if (!request.model.with_ribbon) return write_still_life(request, job);
  if (job.format == OutputFormat::numbers)
    return write_number_table(request, job.reader, job.frames);
  if (job.format == OutputFormat::whole_motion) return write_whole_motion(request, std::move(job));
  return write_frame_sequence(request, std::move(job));
}

}  // namespace

Result<ConversionReport> convert(const ConversionRequest& wanted) {
  auto job = open_job(wanted);
  if (!job) return tl::unexpected(job.error());
  const auto files = planned_files(wanted, *job);
  if (!files) return tl::unexpected(files.error());
  ConversionRequest request = wanted;
  // What was stopped before its first file has left no log, and begins.
  request.resume = wanted.resume && is_taken(files->log);
  if (!request.force && !request.resume)
    if (auto free = check_places(*files); !free) return tl::unexpected(free.error());
  const std::shared_ptr<const SolidRibbon> solid = job->model.solid;
  const double factor = request.model.placement.factor();
  // The obstacle is the same, whatever becomes of the ribbon.
  const int frame_count = job->reader.frame_count();
  auto remarks = request.model.with_ribbon ? remarks_on(*job) : std::vector<std::string>{};
  return write_job(request, std::move(*job)).map([&](ConversionReport report) {
    report.frame_count = frame_count;
    if (solid) report.least_thickness_m = solid->least_thickness() / factor;
    if (solid) report.most_pinched = solid->most_pinched();
    report.remarks.insert(report.remarks.begin(), remarks.begin(), remarks.end());
    return report;
  });
}

}  // namespace ribbon
