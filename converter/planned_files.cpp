#include "converter/planned_files.h"

#include "converter/export/obj_text.h"
#include "converter/motion_format.h"
#include "converter/output_names.h"
#include "converter/sequence_names.h"

namespace ribbon {

namespace {

std::filesystem::path library_beside(const std::filesystem::path& output) {
  return output.parent_path() / material_library_name(output.string());
}

// The obstacle alone, numbers, or a whole motion, perhaps with the mesh that it deforms.
PlannedFiles files_of_one(const std::filesystem::path& output, OutputFormat format) {
  PlannedFiles files;
  files.own = {output};
  const bool has_base = format == OutputFormat::whole_motion && motion_format(output)->deforms_base;
  if (has_base) files.own.push_back(std::filesystem::path(output).replace_extension(".obj"));
  if (has_base || format == OutputFormat::obj) files.libraries = {library_beside(output)};
  return files;
}

PlannedFiles files_of_sequence(const SequenceNames& names, OutputFormat format) {
  PlannedFiles files;
  files.own = names.frames();
  files.log = names.log();
  const auto libraries = names.libraries();
  if (format == OutputFormat::obj) files.libraries.assign(libraries.begin(), libraries.end());
  return files;
}

}  // namespace

Result<PlannedFiles> planned_files(const ConversionRequest& request, const ConversionJob& job) {
  PlannedFiles files;
  if (is_one_file(job.format) || !request.model.with_ribbon) {
    files = files_of_one(request.output, job.format);
  } else {
    const auto names = SequenceNames::of(request, job.frames);
    if (!names) return tl::unexpected(names.error());
    files = files_of_sequence(*names, job.format);
  }
  files.library_text = material_library_text(job.model);
  return files;
}

}  // namespace ribbon
