#include "player/page/page_options.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "commandline/extension.h"

namespace ribbon {

bool is_page(const std::string& output) {
  return lower_case_extension(output) == ".html";
}

Result<void> check_page_options(const std::vector<GivenArgument>& given) {
  constexpr std::array<std::string_view, 6> followed = {"RECORDING", "--output",   "--force",
                                                        "--quiet",   "--progress", "--threads"};
  const auto other = std::find_if(given.begin(), given.end(), [&](const GivenArgument& one) {
    return std::find(followed.begin(), followed.end(), one.name) == followed.end();
  });
  if (other == given.end()) return {};
  return failure(other->name, "does not go with a page, which holds the whole recording",
                 "leave it out; in the page frames and views are chosen by hand");
}

}  // namespace ribbon
