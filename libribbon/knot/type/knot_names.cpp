#include "knot/type/knot_names.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdlib>

#include "knot/type/jones_polynomial.h"

namespace ribbon {
namespace {

// A knot and how to braid it (after V. F. R. Jones, "Hecke algebra representations of braid groups
// and link polynomials", 1987, up to our choice of mirror image: the crossings of the least diagram
// are right-handed in the sum).
struct NamedBraid {
  const char* name;
  int crossings;
  bool has_mirror_image;  // that differs from it
  std::vector<int> letters;
};

const std::vector<NamedBraid>& named_braids() {
  static const std::vector<NamedBraid> result{
      {"unknot", 0, false, {1}},
      {"trefoil", 3, true, {1, 1, 1}},
      {"figure-eight knot", 4, false, {1, -2, 1, -2}},
      {"cinquefoil knot 5_1", 5, true, {1, 1, 1, 1, 1}},
      {"three-twist knot 5_2", 5, true, {1, 1, 1, 2, -1, 2}},
      {"stevedore knot 6_1", 6, true, {1, 1, 2, -1, -3, 2, -3}},
      {"knot 6_2", 6, true, {1, 1, 1, -2, 1, -2}},
      {"knot 6_3", 6, false, {1, 1, -2, 1, -2, -2}},
      {"granny knot", 6, true, {1, 1, 1, 2, 2, 2}},
      {"reef knot", 6, false, {1, 1, 1, -2, -2, -2}},
      {"septafoil knot 7_1", 7, true, {1, 1, 1, 1, 1, 1, 1}},
      {"knot 7_2", 7, true, {1, 1, 1, 2, -1, 2, 3, -2, 3}},
      {"knot 7_3", 7, true, {1, 1, 1, 1, 1, 2, -1, 2}},
      {"knot 7_4", 7, true, {1, 1, 2, -1, 2, 2, 3, -2, 3}},
      {"knot 7_5", 7, true, {1, 1, 1, 1, 2, -1, 2, 2}},
      {"knot 7_6", 7, true, {1, 1, -2, 1, 3, -2, 3}},
      {"knot 7_7", 7, true, {1, -2, 1, -2, 3, -2, 3}},
      {"trefoil and figure-eight knot", 7, true, {1, 1, 1, 2, -3, 2, -3}},
      {"carrick mat 8_18", 8, false, {1, -2, 1, -2, 1, -2, 1, -2}},
      {"torus knot 8_19", 8, true, {1, 1, 1, 2, 1, 1, 1, 2}},
  };
  return result;
}

struct NamedPolynomial {
  LaurentPolynomial jones;
  std::string name;
};

void append_names(const NamedBraid& braid, std::vector<NamedPolynomial>& names) {
  const auto jones = jones_polynomial(braid_knot(braid.letters));
  assert(jones);
  const std::string crossings =
      braid.crossings == 0 ? "" : " (" + std::to_string(braid.crossings) + " crossings)";
  const std::string name = braid.name;
  if (!braid.has_mirror_image) {
    names.push_back({*jones, name + crossings});
  } else {
    names.push_back({*jones, name + ", right-handed" + crossings});
    names.push_back({jones->mirrored(), name + ", left-handed" + crossings});
  }
}

const std::vector<NamedPolynomial>& named_polynomials() {
  static const std::vector<NamedPolynomial> names = [] {
    std::vector<NamedPolynomial> result;
    for (const NamedBraid& braid : named_braids()) append_names(braid, result);
    return result;
  }();
  return names;
}

// One passage of a strand through all letters, from position `strand` to the one returned.
int pass_through(const std::vector<int>& letters, int strand,
                 std::vector<KnotDiagram::Pass>& passes) {
  for (std::size_t k = 0; k < letters.size(); ++k) {
    const int left = std::abs(letters[k]) - 1;
    if (strand != left && strand != left + 1) continue;
    const bool comes_from_right = strand == left + 1;
    passes.push_back({static_cast<int>(k), comes_from_right == (letters[k] > 0)});
    strand = comes_from_right ? left : left + 1;
  }
  return strand;
}

}  // namespace

KnotDiagram braid_knot(const std::vector<int>& letters) {
  KnotDiagram result;
  for (const int letter : letters) result.signs.push_back(letter > 0 ? 1 : -1);
  int strand = 0;
  do strand = pass_through(letters, strand, result.passes);
  while (strand != 0);
  assert(result.passes.size() == 2 * letters.size());
  return result;
}

std::optional<std::string> knot_name(const LaurentPolynomial& jones) {
  const auto& names = named_polynomials();
  const auto found = std::find_if(names.begin(), names.end(),
                                  [&jones](const auto& named) { return named.jones == jones; });
  if (found == names.end()) return {};
  return found->name;
}

std::vector<std::string> all_knot_names() {
  std::vector<std::string> names;
  for (const NamedPolynomial& named : named_polynomials()) names.push_back(named.name);
  return names;
}

std::string knot_text(const LaurentPolynomial& jones) {
  const auto name = knot_name(jones);
  return name ? *name : "knot with Jones polynomial " + jones.text();
}

}  // namespace ribbon
