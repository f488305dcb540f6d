#include "converter/companions.h"

#include "converter/motion_format.h"
#include "converter/output_names.h"
#include "files/files.h"
#include "model/obj_text.h"
#include "model/picture_file.h"

namespace ribbon {

namespace {

bool has_library(const ConversionRequest& request, OutputFormat format) {
  return format == OutputFormat::obj ||
         (format == OutputFormat::whole_motion && motion_format(request.output)->deforms_base);
}

bool holds_picture(const ConversionRequest& request, OutputFormat format) {
  return format == OutputFormat::whole_motion &&
         motion_format(request.output)->picture == PicturePlace::inside;
}

}  // namespace

std::vector<Companion> companions_of(const ConversionRequest& request, const ConversionJob& job) {
  std::vector<Companion> companions;
  if (has_library(request, job.format))
    companions.push_back(
        {.name = material_library_name(request.output),
         .content = std::make_shared<const std::string>(material_library_text(job.model))});
  for (const Material& material : materials_of(job.model)) {
    const auto& picture = material.picture;
    if (!picture || holds_picture(request, job.format)) continue;
    companions.push_back({.name = picture->name,
                          .content = std::shared_ptr<const std::string>(picture, &picture->bytes)});
  }
  return companions;
}

Result<void> write_companions(const std::vector<Companion>& companions,
                              const std::filesystem::path& folder, Older older) {
  for (const Companion& companion : companions) {
    const std::filesystem::path file = folder / companion.name;
    if (read_file(file) == *companion.content) continue;
    // Where nothing is, another conversion may be about to write the same.
    const Older others = is_taken(file) ? older : Older::is_replaced;
    if (auto written = write_file(file, *companion.content, others); !written) return written;
  }
  return {};
}

}  // namespace ribbon
