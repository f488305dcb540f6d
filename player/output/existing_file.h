// Nothing that is there is replaced unless the user says so.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "files/part_file.h"
#include "result/result.h"

namespace ribbon {

// What may be replaced of what is there.
struct Replaceable {
  bool all = false;                          // files, but
  std::vector<std::filesystem::path> never;  // those that are read for what is written

  // Of what has come since check_place(), while something was made.
  [[nodiscard]] Older later() const { return all ? Older::is_replaced : Older::stays; }
};

// Fails where a file of this name is there and is not to be replaced. other_way: what may be done
// then besides choosing another name and --force.
Result<void> check_place(const std::filesystem::path& file, const Replaceable& replaceable,
                         std::string_view other_way = "");

}  // namespace ribbon
