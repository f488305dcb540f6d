// What a program of the tests cannot go on without.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <type_traits>

#include "result/result.h"

namespace ribbon {

// The answer's value; an error ends the program with its sentence and exit code 2.
template <class Value>
Value demanded(Result<Value> answer) {
  if (!answer) {
    std::fprintf(stderr, "%s\n", answer.error().sentence().c_str());
    std::exit(2);
  }
  if constexpr (!std::is_void_v<Value>) return std::move(*answer);
}

}  // namespace ribbon
