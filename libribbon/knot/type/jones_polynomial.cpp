#include "knot/type/jones_polynomial.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace ribbon {
namespace {

using Index = std::size_t;

// The four edge ends at a crossing, counter-clockwise from the incoming lower one. Edge k leads to
// pass k of the long knot, so that the knot begins with edge 0 and ends with edge passes.size().
using Legs = std::array<int, 4>;

std::vector<Legs> planar_diagram(const KnotDiagram& diagram) {
  std::vector<Legs> result(diagram.signs.size());
  for (Index k = 0; k < diagram.passes.size(); ++k) {
    const auto crossing = static_cast<Index>(diagram.passes[k].crossing);
    const int in = static_cast<int>(k);
    Legs& legs = result[crossing];
    if (!diagram.passes[k].over) {
      legs[0] = in;
      legs[2] = in + 1;
    } else {
      // The upper strand comes from the left of the lower one where the crossing is right-handed.
      const bool from_left = diagram.signs[crossing] > 0;
      legs[3] = from_left ? in : in + 1;
      legs[1] = from_left ? in + 1 : in;
    }
  }
  return result;
}

constexpr int closed = -1;

// How the edge ends met so far are joined by the smoothed crossings: partner[edge], or `closed`
// for edges that lie inside or have not been met.
using Matching = std::vector<int>;
using StateSum = std::map<Matching, LaurentPolynomial>;

// Follows `edge` through what has been smoothed already, to an open end.
int other_end(Matching& matching, int edge) {
  return std::exchange(matching[static_cast<Index>(edge)], closed);
}

// Joins two legs of a crossing. True if that closes a loop.
bool join(Matching& matching, int a, int b) {
  if (a == b || matching[static_cast<Index>(a)] == b) {
    matching[static_cast<Index>(a)] = matching[static_cast<Index>(b)] = closed;
    return true;
  }
  const auto far_end = [&matching](int edge) {
    const int end = other_end(matching, edge);
    return end == closed ? edge : end;
  };
  const int from = far_end(a);
  const int to = far_end(b);
  matching[static_cast<Index>(from)] = to;
  matching[static_cast<Index>(to)] = from;
  return false;
}

using Pairing = std::array<std::pair<int, int>, 2>;

// Adds `value`, multiplied by A^power, for every state of `before` after the legs are joined as
// `pairing` says. False when a coefficient is too large.
bool add_smoothed(StateSum& after, const Matching& before, const LaurentPolynomial& value,
                  const Pairing& pairing, int power) {
  static const LaurentPolynomial loop{-2, {-1, 0, 0, 0, -1}};
  Matching matching = before;
  std::optional<LaurentPolynomial> term = product(value, LaurentPolynomial::monomial(1, power));
  for (const auto& [a, b] : pairing)
    if (join(matching, a, b) && term) term = product(*term, loop);
  if (!term) return false;
  LaurentPolynomial& total = after[std::move(matching)];
  const std::optional<LaurentPolynomial> new_total = sum(total, *term);
  if (!new_total) return false;
  total = *new_total;
  return true;
}

std::optional<StateSum> smoothed(const StateSum& before, const Legs& legs) {
  const auto& [i, j, k, l] = legs;
  StateSum after;
  for (const auto& [matching, value] : before) {
    if (!add_smoothed(after, matching, value, {{{i, j}, {k, l}}}, 1)) return {};
    if (!add_smoothed(after, matching, value, {{{i, l}, {j, k}}}, -1)) return {};
  }
  return after;
}

// Takes the crossing out of `remaining` that has most legs on edges met already: the number of open
// ends, which the number of states grows with, stays small.
Legs take_next(std::vector<Legs>& remaining, const std::vector<bool>& met) {
  const auto known = [&met](const Legs& legs) {
    return std::count_if(legs.begin(), legs.end(),
                         [&met](int edge) { return met[static_cast<Index>(edge)]; });
  };
  const auto next = std::max_element(
      remaining.begin(), remaining.end(),
      [&known](const Legs& one, const Legs& other) { return known(one) < known(other); });
  const Legs result = *next;
  remaining.erase(next);
  return result;
}

// Kauffman's bracket in A, which is 1 for a strand without crossings.
std::optional<LaurentPolynomial> bracket(const KnotDiagram& diagram) {
  constexpr Index too_many_states = 5000;
  const Index edges = diagram.passes.size() + 1;
  std::vector<Legs> remaining = planar_diagram(diagram);
  std::vector<bool> met(edges);
  met.front() = met.back() = true;
  Matching strand(edges, closed);
  if (remaining.empty()) return LaurentPolynomial::monomial(1, 0);
  StateSum states{{strand, LaurentPolynomial::monomial(1, 0)}};
  while (!remaining.empty()) {
    const Legs legs = take_next(remaining, met);
    for (const int edge : legs) met[static_cast<Index>(edge)] = true;
    std::optional<StateSum> next = smoothed(states, legs);
    if (!next || next->size() > too_many_states) return {};
    states = *std::move(next);
  }
  assert(states.size() == 1);  // the two ends of the long knot are joined
  return states.begin()->second;
}

}  // namespace

std::optional<LaurentPolynomial> jones_polynomial(const KnotDiagram& diagram) {
  const int writhe = diagram.writhe();
  std::optional<LaurentPolynomial> result = bracket(diagram);
  if (!result) return {};
  // (-A^3)^-writhe times the bracket, then A = t^(-1/4).
  result = product(*result, LaurentPolynomial::monomial(writhe % 2 == 0 ? 1 : -1, -3 * writhe));
  if (!result) return {};
  LaurentPolynomial in_t;
  for (Index k = 0; k < result->coefficients.size(); ++k) {
    const int power = result->lowest_power + static_cast<int>(k);
    const std::int64_t coefficient = result->coefficients[k];
    if (coefficient == 0) continue;
    assert(power % 4 == 0);
    const auto total = sum(in_t, LaurentPolynomial::monomial(coefficient, -power / 4));
    if (!total) return {};
    in_t = *total;
  }
  return in_t;
}

}  // namespace ribbon
