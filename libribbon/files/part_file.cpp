#include "files/part_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "files/files.h"

namespace ribbon {

namespace {

// Of which file this is a temporary name; empty: of none.
std::filesystem::path whole_of(const std::string& name) {
  const std::size_t mark = name.rfind(temporary_mark);
  if (mark == std::string::npos) return {};
  const std::string_view number = std::string_view(name).substr(mark + temporary_mark.size());
  const bool is_number = !number.empty() && std::all_of(number.begin(), number.end(), [](char c) {
    return c >= '0' && c <= '9';
  });
  return is_number ? name.substr(0, mark) : "";
}

}  // namespace

Result<PartFile> PartFile::create(const std::filesystem::path& whole) {
  if (auto created = create_folder_of(whole); !created) return tl::unexpected(created.error());
  for (long number = ::getpid();; ++number) {
    std::filesystem::path path =
        linked_file(whole).string() + std::string(temporary_mark) + std::to_string(number);
    FileDescriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.is_open()) return PartFile(std::move(path), std::move(file));
    if (errno != EEXIST) return cannot_be_written(whole);
  }
}

PartFile::~PartFile() {
  if (!path_.empty()) ::unlink(path_.c_str());
}

Result<void> PartFile::take_place_of(const std::filesystem::path& whole, Older older) {
  if (older == Older::stays) return take_free_place(whole);
  const std::filesystem::path replaced = linked_file(whole);
  std::error_code code;
  if (const auto status = std::filesystem::status(replaced, code); is_regular_file(status))
    std::filesystem::permissions(path_, status.permissions(), code);
  if (::rename(path_.c_str(), replaced.c_str()) == 0) {
    path_.clear();
    return {};
  }
  if (errno == ENOENT)
    return passing_failure(whole.string(), "was removed by somebody else while it was written",
                           "run it again");
  return failure(whole.string(), "cannot be replaced (" + last_error_text() + ")",
                 "check the permissions of its folder");
}

// A second name is given in one step, and only where it is free; then the first one goes.
Result<void> PartFile::take_free_place(const std::filesystem::path& whole) {
  if (::link(path_.c_str(), whole.c_str()) == 0) {
    ::unlink(path_.c_str());
    path_.clear();
    return {};
  }
  // A file system that knows no second names, as those of memory cards.
  if (errno != EEXIST && !is_taken(whole)) return take_place_of(whole);
  const std::filesystem::path stays = std::exchange(path_, {});
  return failure(whole.string(),
                 "was put there by somebody else meanwhile, and is not replaced; what was made is "
                 "complete as " +
                     stays.string(),
                 "rename it");
}

void remove_leftovers(const std::vector<std::filesystem::path>& files) {
  std::set<std::filesystem::path> whole;
  std::set<std::filesystem::path> folders;
  for (const std::filesystem::path& file : files) {
    const std::filesystem::path beside = std::filesystem::path(".") / linked_file(file);
    whole.insert(beside);
    folders.insert(beside.parent_path());
  }
  std::error_code code;
  for (const std::filesystem::path& folder : folders)
    for (const auto& entry : std::filesystem::directory_iterator(folder, code))
      if (whole.contains(whole_of(entry.path().string())))
        std::filesystem::remove(entry.path(), code);
}

}  // namespace ribbon
