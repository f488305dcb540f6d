// Writing to a file descriptor without losing anything on the way.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ribbon {

// Writes all of `bytes`, in one write() where the system lets us, so that a kill leaves whole
// records. False when it could not; last_error_text() then tells why.
bool write_all(int descriptor, std::string_view bytes);

// The system's words for what went wrong last in this thread ("No space left on device").
std::string last_error_text();

// Waits until the names of files in the folder of `path` are on the disk, where the file system
// lets us.
void sync_folder_of(const std::filesystem::path& path);

}  // namespace ribbon
