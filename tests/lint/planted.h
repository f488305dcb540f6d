#pragma once

namespace ribbon {

inline int misnamedFunction(int x) {
  return x;
}

}  // namespace ribbon
