#include "converter/output_place.h"

#include <algorithm>

#include "converter/sequence_log.h"
#include "files/files.h"

namespace ribbon {

namespace {

tl::unexpected<Error> taken(const std::filesystem::path& file) {
  return failure(file.string(), "exists already",
                 "replace it by --force, or name another file after -o");
}

}  // namespace

int existing_count(const std::vector<std::filesystem::path>& files) {
  return static_cast<int>(std::count_if(files.begin(), files.end(), is_taken));
}

Result<void> check_places(const PlannedFiles& files) {
  if (SequenceLog::is_at(files.log))
    return failure(files.log.string(), "tells that a conversion was stopped here",
                   "go on with it by --resume, or begin anew with --force");
  if (is_taken(files.log)) return taken(files.log);
  for (const std::filesystem::path& file : files.own)
    if (is_taken(file)) return taken(file);
  for (const auto& [file, content] : files.shared)
    if (is_taken(file) && read_file(file) != *content) return taken(file);
  return {};
}

}  // namespace ribbon
