// Names of objects in formats that do not take all that a model's may contain.
#pragma once

#include <string>
#include <vector>

namespace ribbon {

// The names; where two are the same, the later one gets "_2", "_3" and so on.
std::vector<std::string> unique_names(const std::vector<std::string>& wanted);

}  // namespace ribbon
