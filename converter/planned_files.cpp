#include "converter/planned_files.h"

#include <filesystem>
#include <set>
#include <system_error>

#include "converter/companions.h"
#include "converter/motion_format.h"
#include "converter/sequence_names.h"
#include "files/files.h"

namespace ribbon {

namespace {

// The obstacle alone, numbers, or a whole motion, perhaps with the mesh that it deforms.
PlannedFiles files_of_one(const std::filesystem::path& output, OutputFormat format) {
  PlannedFiles files;
  files.own = {output};
  if (format == OutputFormat::whole_motion && motion_format(output)->deforms_base)
    files.own.push_back(std::filesystem::path(output).replace_extension(".obj"));
  return files;
}

PlannedFiles files_of_sequence(const SequenceNames& names) {
  PlannedFiles files;
  files.own = names.frames();
  files.log = names.log();
  return files;
}

// They are written under the output's name, which may be that of the other's file.
Result<void> check_pictures(const ConversionRequest& request, const PlannedFiles& files) {
  std::error_code code;
  for (const std::filesystem::path& texture : {request.texture, request.texture_back})
    for (const auto& [file, content] : files.shared)
      if (std::filesystem::equivalent(file, texture, code) && read_file(file) != *content)
        return failure(file.string(), "is a picture that the ribbon shows, which would be lost",
                       "write to another folder");
  return {};
}

}  // namespace

Result<PlannedFiles> planned_files(const ConversionRequest& request, const ConversionJob& job) {
  PlannedFiles files;
  std::set<std::filesystem::path> folders;
  if (is_one_file(job.format) || !request.model.with_ribbon) {
    files = files_of_one(request.output, job.format);
    folders = {std::filesystem::path(request.output).parent_path()};
  } else {
    const auto names = SequenceNames::of(request, job.frames);
    if (!names) return tl::unexpected(names.error());
    files = files_of_sequence(*names);
    folders = names->folders();
  }
  // The recording is there, so what is not there is another file.
  std::error_code code;
  for (const std::filesystem::path& file : files.own)
    if (std::filesystem::equivalent(file, request.recording, code))
      return failure(file.string(), "is the recording that is converted, which would be lost",
                     "name another file after -o");
  for (const std::filesystem::path& folder : folders)
    for (const Companion& companion : companions_of(request, job))
      files.shared.push_back({.file = folder / companion.name, .content = companion.content});
  if (auto kept = check_pictures(request, files); !kept) return tl::unexpected(kept.error());
  return files;
}

}  // namespace ribbon
