#include "recorder/run/drawn_knot.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <variant>

#include "curve/axis_view.h"
#include "curve/object_passages.h"
#include "knot/knot_witness.h"
#include "knot/motion/ribbon_curves.h"
#include "knot/ribbon_part.h"
#include "knot/type/closed_by_rays.h"
#include "knot/type/jones_polynomial.h"
#include "knot/type/knot_names.h"
#include "knot/type/tied_forms.h"
#include "scene/nearest_word.h"

namespace ribbon {

namespace {

constexpr int most_changes = 3;             // that are tried to find what may have been meant
constexpr std::size_t most_to_change = 24;  // crossings: 2300 triples of them

bool is_called(const KnotDiagram& drawing, const std::string& name) {
  const auto names = knot_names(drawing);
  return std::find(names.begin(), names.end(), name) != names.end();
}

void change(Crossing& crossing) {
  crossing.first_over = !crossing.first_over;
  crossing.sign = -crossing.sign;
}

// Changes up to so many crossings, from number `from` on, until the drawing is called so.
bool change_until_called(const std::string& name, int changes, std::size_t from,
                         std::vector<Crossing>& crossings) {
  if (changes == 0) return is_called(diagram_of(crossings), name);
  for (std::size_t i = from; i < crossings.size(); ++i) {
    change(crossings[i]);
    if (change_until_called(name, changes - 1, i + 1, crossings)) return true;
    change(crossings[i]);
  }
  return false;
}

std::string remedy_for(const std::string& name, const RibbonMesh& drawn) {
  std::vector<Crossing> crossings = drawn.crossings;
  if (crossings.size() <= most_to_change)
    for (int changes = 1; changes <= most_changes; ++changes)
      if (change_until_called(name, changes, 0, crossings))
        return "write 'crossings = \"" + letters_of(crossings, drawn.objects) +
               "\"' in [curve], or correct 'expect'";
  return "correct the drawing, its crossings or 'expect'";
}

Result<void> check_name(const NamedKnot& knot, std::string_view key,
                        const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), knot.name) != known.end()) return {};
  const std::string problem = "no knot is known as '" + knot.name + "'";
  for (const std::string_view hand : {", left-handed", ", right-handed"})
    if (knot.name.ends_with(hand)) {
      const std::string name = knot.name.substr(0, knot.name.size() - hand.size());
      if (std::find(known.begin(), known.end(), name) != known.end())
        return failure(knot.place, problem, "write '" + std::string(key) + " = \"" + name + "\"'");
    }
  const auto meant = nearest_word(knot.name, {known.begin(), known.end()});
  return failure(knot.place, problem,
                 meant ? "did you mean '" + std::string(*meant) + "'?"
                       : "write for example '" + std::string(key) +
                             " = \"reef knot\"'; docs/scene.md lists all");
}

// A slipped knot is told by its drawing alone, and ropes are not followed by their drawings.
Result<void> check_type_name(const NamedKnot& knot) {
  const auto& forms = known_knot_names();
  const auto& types = known_type_names();
  if (std::find(forms.begin(), forms.end(), knot.name) != forms.end() &&
      std::find(types.begin(), types.end(), knot.name) == types.end())
    return failure(knot.place,
                   "'" + knot.name +
                       "' is told by a drawing alone, and the band is certified "
                       "where it no longer lies as drawn",
                   "name the knot that the part closes to, for example 'reef knot'");
  return check_name(knot, "expect_between", types);
}

// What lies between two shares of its length.
KnotDiagram part_of(const RibbonMesh& drawn, const std::array<double, 2>& shares) {
  const auto [begin, end] = std::minmax(shares[0], shares[1]);
  const KnotDiagram whole = diagram_of(drawn.crossings);
  std::vector<int> passes_within(whole.signs.size(), 0);
  const auto lies_within = [&, begin = begin, end = end](std::size_t pass) {
    return drawn.passage_shares[pass] > begin && drawn.passage_shares[pass] < end;
  };
  for (std::size_t i = 0; i < whole.passes.size(); ++i)
    if (lies_within(i)) ++passes_within[whole.passes[i].crossing];
  KnotDiagram part;
  std::vector<int> number(whole.signs.size(), -1);
  for (std::size_t i = 0; i < whole.passes.size(); ++i) {
    const int crossing = whole.passes[i].crossing;
    if (!lies_within(i) || passes_within[crossing] < 2) continue;
    if (number[crossing] < 0) {
      number[crossing] = part.crossing_count();
      part.signs.push_back(whole.signs[crossing]);
    }
    part.passes.push_back({number[crossing], whole.passes[i].over});
  }
  return part;
}

Result<void> check_drawn(const KnotScene& knot, const RibbonMesh& drawn) {
  if (auto known = check_name(knot.expect, "expect", known_knot_names()); !known) return known;
  const KnotDiagram drawing = diagram_of(drawn.crossings);
  if (is_called(drawing, knot.expect.name)) return {};
  return failure(
      knot.expect.place,
      "the drawing ties: " + text_of_knot(drawing) + "; expected is: " + knot.expect.name,
      remedy_for(knot.expect.name, drawn));
}

Result<void> check_drawn_between(const KnotScene& knot, const RibbonMesh& drawn) {
  if (!knot.expect_between) return {};
  if (auto known = check_type_name(*knot.expect_between); !known) return known;
  const KnotDiagram part = part_of(drawn, shares_of(*knot.between));
  if (is_called(part, knot.expect_between->name)) return {};
  return failure(knot.expect_between->place,
                 "between the two places the drawing ties: " + text_of_knot(part) +
                     "; expected is: " + knot.expect_between->name,
                 "correct the drawing, its crossings, 'between' or 'expect_between'");
}

// Closed where that is clearest. Nothing where that is not known.
std::optional<LaurentPolynomial> type_of(const RibbonGrid& grid, const Eigen::Matrix3Xf& frame) {
  KnotWitness witness(grid, std::nullopt);
  witness.follow(frame);
  return witness.certificate().jones;
}

// Closed towards the viewer of the drawing, as his pen may join its ends above all that it has
// drawn. Where they lie within loops, this is the type that the drawing has.
std::optional<LaurentPolynomial> type_seen(const RibbonGrid& grid, const Eigen::Matrix3Xf& frame,
                                           Axis axis) {
  constexpr double hardly = 0x1p-10;  // off his line of sight, to tell the two rays apart
  return type_closed_by({in_world({hardly, 0, 1}, axis), in_world({0, hardly, 1}, axis)},
                        ribbon_curves(grid, frame).centre_line);
}

Result<void> check_same(const std::optional<LaurentPolynomial>& drawn,
                        const std::optional<LaurentPolynomial>& begun, const std::string& what) {
  if (!drawn || !begun || drawn == begun) return {};
  return failure(
      "",
      what + " at its start is tied as: " + knot_text(*begun) +
          "; its drawing as: " + knot_text(*drawn),
      "lead both ends of the drawing straight out, leave more room between the strands, or "
      "write a larger ribbon.along");
}

}  // namespace

KnotDiagram diagram_of(const std::vector<Crossing>& crossings) {
  KnotDiagram diagram;
  for (const Passage& passage : passages_along(crossings))
    diagram.passes.push_back({static_cast<int>(passage.crossing), passage.over});
  for (const Crossing& crossing : crossings) diagram.signs.push_back(crossing.sign);
  return diagram;
}

std::optional<LaurentPolynomial> closed_type(const KnotDiagram& drawing) {
  if (!is_planar(drawing)) return std::nullopt;
  return jones_polynomial(reduced(drawing));
}

std::string text_of_knot(const KnotDiagram& drawing) {
  if (!is_planar(drawing)) return "a knot that cannot be told, because an end lies inside a loop";
  const auto jones = closed_type(drawing);
  const std::string type = jones ? knot_text(*jones) : "a knot too tangled to be told";
  const auto form = tied_form(drawing);
  return form ? std::string(*form) + ", closes to " + type : type;
}

std::array<double, 2> shares_of(const BandPart& part) {
  return {std::get<double>(part.ends[0]), std::get<double>(part.ends[1])};
}

Result<void> check_expected_knot(const Scene& scene, const RibbonMesh& drawn) {
  if (!scene.knot) return {};
  Result<void> kept = check_drawn(*scene.knot, drawn);
  return kept ? check_drawn_between(*scene.knot, drawn) : kept;
}

Result<void> check_first_frame(const Scene& scene, const RibbonMesh& drawn,
                               const Eigen::Matrix3Xd& start) {
  const Eigen::Matrix3Xf frame = start.cast<float>();
  const auto type = closed_type(diagram_of(drawn.crossings));
  Result<void> same = type && type_seen(drawn.grid, frame, scene.curve.axis) == type
                          ? Result<void>()
                          : check_same(type, type_of(drawn.grid, frame), "the ribbon");
  if (!same || !scene.knot || !scene.knot->between) return same;
  const auto shares = shares_of(*scene.knot->between);
  const auto rows = part_between(drawn.grid, shares[0], shares[1]);
  if (!rows)
    return failure("", "no two rows lie between the two places of 'between'",
                   "name two that are further apart");
  // Closed as it will be when it is certified.
  return check_same(closed_type(part_of(drawn, shares)),
                    type_of(rows->grid(drawn.grid), rows->positions(drawn.grid, frame)),
                    "the part of the ribbon between the two places of 'between'");
}

}  // namespace ribbon
