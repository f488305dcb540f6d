// What went wrong in the outside world, as a Python exception.
#pragma once

#include <type_traits>
#include <utility>

#include "result/result.h"

namespace ribbon::python {

// Throws ribbon.Error with the error's place, problem and remedy.
[[noreturn]] void raise(const Error& error);

template <class Value>
Value value_of(Result<Value> result) {
  if (!result) raise(result.error());
  if constexpr (!std::is_void_v<Value>) return *std::move(result);
}

}  // namespace ribbon::python
