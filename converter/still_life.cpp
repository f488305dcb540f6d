#include "converter/still_life.h"

#include "converter/companions.h"
#include "converter/encode_model.h"
#include "converter/output_names.h"
#include "files/files.h"

namespace ribbon {

Result<ConversionReport> write_still_life(const ConversionRequest& request,
                                          const ConversionJob& job) {
  const std::filesystem::path output = request.output;
  const std::string library = material_library_name(request.output);
  const auto bytes = encode_model(job.format, job.model, library);
  if (!bytes) return tl::unexpected(bytes.error());
  if (auto written =
          write_companions(companions_of(request, job), output.parent_path(), request.later());
      !written)
    return tl::unexpected(written.error());
  return write_file(output, *bytes, request.later()).map([&] {
    ConversionReport report;
    report.bytes_written = bytes->size();
    report.first_file = report.last_file = output;
    return report;
  });
}

}  // namespace ribbon
