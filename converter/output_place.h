// Nothing is overwritten unasked.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "result/result.h"

namespace ribbon {

// What a conversion is going to write.
struct PlannedFiles {
  std::vector<std::filesystem::path> own;
  // May be shared with other conversions, so that they may exist if they hold just this.
  struct Shared {
    std::filesystem::path file;
    std::shared_ptr<const std::string> content;
  };
  std::vector<Shared> shared;
  std::filesystem::path log;  // of a sequence while it is unfinished; empty: there is none
};

// How many of `files` exist.
int existing_count(const std::vector<std::filesystem::path>& files);

// Fails, naming the first, where something would be overwritten.
Result<void> check_places(const PlannedFiles& files);

}  // namespace ribbon
