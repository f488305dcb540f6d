// What somebody is told where something cannot be done, and what tests say of that text.
#pragma once

#include <gmock/gmock.h>

#include <string>

#include "result/result.h"

namespace ribbon {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// The error's one sentence; "" where there is none.
template <class Value>
std::string refusal_of(const Result<Value>& answer) {
  return answer ? "" : answer.error().sentence();
}

}  // namespace ribbon
