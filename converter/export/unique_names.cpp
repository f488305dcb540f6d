#include "converter/export/unique_names.h"

#include <algorithm>

namespace ribbon {

std::vector<std::string> unique_names(const std::vector<std::string>& wanted) {
  std::vector<std::string> names;
  for (const std::string& first_choice : wanted) {
    std::string name = first_choice;
    for (int number = 2; std::find(names.begin(), names.end(), name) != names.end(); ++number)
      name = first_choice + "_" + std::to_string(number);
    names.push_back(name);
  }
  return names;
}

}  // namespace ribbon
