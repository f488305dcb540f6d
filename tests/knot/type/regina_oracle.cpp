#include "knot/type/regina_oracle.h"

#include <link/link.h>

#include <cstdint>

namespace ribbon {
namespace {

LaurentPolynomial in_t(const regina::Laurent<regina::Integer>& in_root_of_t) {
  LaurentPolynomial result;
  for (long power = in_root_of_t.minExp(); power <= in_root_of_t.maxExp(); ++power) {
    const regina::Integer& coefficient = in_root_of_t[power];
    if (coefficient == 0) continue;
    const auto term = LaurentPolynomial::monomial(
        static_cast<std::int64_t>(coefficient.longValue()), static_cast<int>(power / 2));
    result = sum(result, term).value();
  }
  return result;
}

}  // namespace

LaurentPolynomial regina_jones(const KnotDiagram& diagram) {
  if (diagram.signs.empty()) return LaurentPolynomial::monomial(1, 0);
  std::vector<std::vector<int>> strands(1);
  for (const auto& [crossing, over] : diagram.passes)
    strands[0].push_back(over ? crossing + 1 : -(crossing + 1));
  return in_t(regina::Link::fromData(diagram.signs.begin(), diagram.signs.end(), strands.begin(),
                                     strands.end())
                  .jones());
}

LaurentPolynomial regina_jones_of_code(const std::vector<int>& dowker_thistlethwaite) {
  return in_t(
      regina::Link::fromDT(dowker_thistlethwaite.begin(), dowker_thistlethwaite.end()).jones());
}

}  // namespace ribbon
