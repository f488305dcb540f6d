// Whole files in and out. A file appears under its name complete or not at all.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

#include "files/part_file.h"
#include "result/result.h"

namespace ribbon {

// Is there something that a file of this name would replace? Symbolic links that lead nowhere are
// there, too; devices and pipes are nothing that could be lost.
bool is_taken(const std::filesystem::path& path);

// Would both names be those of one file? Neither needs to be there.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

// What people write or draw is smaller; a file can claim any size without taking any room.
inline constexpr std::uintmax_t most_bytes_by_hand = 64'000'000;

// Reads all of `path`. Fails when it cannot be opened or read, is a folder or a device, or is
// larger than `most_bytes`, which no more is read of.
Result<std::string> read_file(
    const std::filesystem::path& path,
    std::uintmax_t most_bytes = std::numeric_limits<std::uintmax_t>::max());

// Writes `bytes` beside `path` under a temporary name, flushes and renames, so that a crash or a
// full disk never leaves half a file under `path`. Creates missing parent folders. On failure the
// temporary is removed and an older file under `path` is untouched; but where that stays as asked
// for, so does the temporary (PartFile::take_place_of()).
Result<void> write_file(const std::filesystem::path& path, std::string_view bytes,
                        Older older = Older::is_replaced);

}  // namespace ribbon
