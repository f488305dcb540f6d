// How a ribbon came to its start.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <string_view>

namespace ribbon {

enum class StartKind {
  free,       // as generated, it intersected nothing
  grown,      // from a thin band that was free, its width raised through the gate
  recovered,  // schemes A, B and C moved it out of what it pierced
};

// "free", "grown" or "recovered".
std::string_view word_for(StartKind kind);

struct StartReport {
  StartKind kind = StartKind::free;
  int recovery_iterations = 0;  // how often a scheme was applied
  int penetrating_edges = 0;    // left; none with the gate
};

// Called with what becomes of the ribbon while its start is looked for, which may take minutes:
// "the ribbon is grown to 40 % of its width". Gives false where it is to be given up. May be empty.
using StartObserver = std::function<bool(const std::string& what)>;

// Is the ribbon still the knot that was meant, with its particles there (3 x particles)? May be
// empty: any will do.
using StartTest = std::function<bool(const Eigen::Matrix3Xd& positions)>;

}  // namespace ribbon
