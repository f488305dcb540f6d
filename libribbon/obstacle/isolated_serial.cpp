// For WebAssembly, which has no processes.
#include "obstacle/isolated.h"

namespace ribbon {

std::optional<std::string> isolated(const std::function<std::string()>& work, unsigned /*most_s*/) {
  return work();
}

}  // namespace ribbon
