// What lies beside the files of a conversion, which refer to it: the material library of OBJ, and
// the picture that materials show.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "converter/conversion_job.h"
#include "result/result.h"

namespace ribbon {

struct Companion {
  std::string name;  // without a folder
  std::shared_ptr<const std::string> content;
};

std::vector<Companion> companions_of(const ConversionRequest& request, const ConversionJob& job);

// What is there already and holds the same, stays as it is: it may be where the picture came from.
// older: what becomes of others.
Result<void> write_companions(const std::vector<Companion>& companions,
                              const std::filesystem::path& folder, Older older);

}  // namespace ribbon
