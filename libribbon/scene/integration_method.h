// How the displacement of a step is computed, and what scenes call it.
#pragma once

#include <array>
#include <string_view>
#include <utility>

namespace ribbon {

// Fourth-order Runge-Kutta as in the paper, symplectic Euler, or backward Euler.
enum class IntegrationMethod { rk4, symplectic_euler, implicit };

inline constexpr std::array<std::pair<std::string_view, IntegrationMethod>, 3> integration_methods{
    {{"rk4", IntegrationMethod::rk4},
     {"symplectic_euler", IntegrationMethod::symplectic_euler},
     {"implicit", IntegrationMethod::implicit}}};

constexpr std::string_view word_for(IntegrationMethod method) {
  std::string_view found;
  for (const auto& [word, other] : integration_methods)
    if (other == method) found = word;
  return found;
}

}  // namespace ribbon
