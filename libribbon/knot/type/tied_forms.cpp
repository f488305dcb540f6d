#include "knot/type/tied_forms.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "knot/type/jones_polynomial.h"
#include "knot/type/knot_names.h"

namespace ribbon {
namespace {

struct TiedForm {
  std::string_view name;
  std::string_view code;  // seen along the axis of the object, which lies in the loop of the walk
};

// Ashley, "The Ashley Book of Knots", 1944, number 1212 (bow); Fink and Mao, "Designing tie knots
// by random walks", 1999 (four-in-hand Li Ro Li Co T, Windsor Li Co Ri Lo Ci Ro Li Co T).
constexpr std::array forms = {
    TiedForm{"bow",
             "O1- O2+ U3+ U4- O5- O6+ O7- O8+ U9+ U10- O11- O12+ O13- U14- O15- U13- O14- U15- "
             "U8+ U5- O4- O9+ U12+ U1- U2+ U11- O10- O3+ U6+ U7-"},
    TiedForm{"four-in-hand", "U1- O2- U3- O4- U5- O3- U2- U6+ O7+ O1- U4- O5- O6+ U7+"},
    TiedForm{"Windsor knot",
             "U1+ O2- O3- O4+ O5+ U6- O7- O1+ U8+ U5+ O9+ U10+ U2- O11- U4+ U12- O13- U3- U11- "
             "O8+ O6- U9+ O12- U13- O10+ U7-"},
};

struct Alias {
  std::string_view name;
  std::string_view of;
};

constexpr std::array aliases = {
    Alias{"overhand knot", "trefoil"},
    Alias{"cinquefoil knot", "cinquefoil knot 5_1"},
    Alias{"stevedore knot", "stevedore knot 6_1"},
    Alias{"square knot", "reef knot"},
};

// As seen from behind: the knot is the same, and so are its signs.
KnotDiagram from_behind(KnotDiagram diagram) {
  for (KnotDiagram::Pass& pass : diagram.passes) pass.over = !pass.over;
  return diagram;
}

KnotDiagram reversed(KnotDiagram diagram) {
  std::reverse(diagram.passes.begin(), diagram.passes.end());
  return diagram;
}

// The drawing reflected on a line in it.
KnotDiagram reflected(KnotDiagram diagram) {
  for (int& sign : diagram.signs) sign = -sign;
  return diagram;
}

bool has_form(const KnotDiagram& drawing, std::string_view code) {
  for (const KnotDiagram& walked : {drawing, reversed(drawing)})
    for (const KnotDiagram& seen : {walked, from_behind(walked)})
      if (gauss_code(seen) == code || gauss_code(reflected(seen)) == code) return true;
  return false;
}

// The name, and what is before a comma in it.
void append_with_general(std::string_view name, std::vector<std::string>& names) {
  const std::string_view general = name.substr(0, name.find(','));
  for (const std::string_view word : {name, general})
    if (std::find(names.begin(), names.end(), word) == names.end()) names.emplace_back(word);
  for (const Alias& alias : aliases)
    if (alias.of == general) append_with_general(alias.name, names);
}

}  // namespace

std::string gauss_code(const KnotDiagram& drawing) {
  std::vector<int> number(drawing.signs.size(), 0);
  int met = 0;
  std::string code;
  for (const KnotDiagram::Pass& pass : drawing.passes) {
    const auto crossing = static_cast<std::size_t>(pass.crossing);
    if (number[crossing] == 0) number[crossing] = ++met;
    if (!code.empty()) code += ' ';
    code += pass.over ? 'O' : 'U';
    code += std::to_string(number[crossing]);
    code += drawing.signs[crossing] > 0 ? '+' : '-';
  }
  return code;
}

std::vector<std::string> names_of_type(const LaurentPolynomial& jones) {
  std::vector<std::string> names;
  if (const auto name = knot_name(jones))
    append_with_general(std::string_view(*name).substr(0, name->find(" (")), names);
  return names;
}

std::optional<std::string_view> tied_form(const KnotDiagram& drawing) {
  for (const TiedForm& form : forms)
    if (has_form(drawing, form.code)) return form.name;
  return std::nullopt;
}

std::vector<std::string> knot_names(const KnotDiagram& drawing) {
  std::vector<std::string> names;
  if (const auto form = tied_form(drawing)) names.emplace_back(*form);
  if (!is_planar(drawing)) return names;
  if (const auto jones = jones_polynomial(reduced(drawing)))
    for (std::string& name : names_of_type(*jones)) names.push_back(std::move(name));
  return names;
}

const std::vector<std::string>& known_knot_names() {
  static const std::vector<std::string> known = [] {
    std::vector<std::string> names = known_type_names();
    for (const TiedForm& form : forms) names.emplace_back(form.name);
    return names;
  }();
  return known;
}

const std::vector<std::string>& known_type_names() {
  static const std::vector<std::string> known = [] {
    std::vector<std::string> names;
    for (const std::string& name : all_knot_names())
      append_with_general(std::string_view(name).substr(0, name.find(" (")), names);
    return names;
  }();
  return known;
}

}  // namespace ribbon
