#include "recorder/run/drawn_knot.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string_view>

#include "curve/object_passages.h"
#include "knot/knot_witness.h"
#include "knot/type/jones_polynomial.h"
#include "knot/type/knot_names.h"
#include "knot/type/tied_forms.h"
#include "scene/nearest_word.h"

namespace ribbon {

namespace {

constexpr int most_changes = 3;             // that are tried to find what may have been meant
constexpr std::size_t most_to_change = 24;  // crossings: 2300 triples of them

bool is_called(const std::vector<Crossing>& crossings, const std::string& name) {
  const auto names = knot_names(diagram_of(crossings));
  return std::find(names.begin(), names.end(), name) != names.end();
}

void change(Crossing& crossing) {
  crossing.first_over = !crossing.first_over;
  crossing.sign = -crossing.sign;
}

// Changes up to so many crossings, from number `from` on, until the drawing is called so.
bool change_until_called(const std::string& name, int changes, std::size_t from,
                         std::vector<Crossing>& crossings) {
  if (changes == 0) return is_called(crossings, name);
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

Result<void> check_name(const KnotScene& knot) {
  const auto& known = known_knot_names();
  if (std::find(known.begin(), known.end(), knot.expect) != known.end()) return {};
  const auto meant = nearest_word(knot.expect, {known.begin(), known.end()});
  return failure(knot.place, "no knot is known as '" + knot.expect + "'",
                 meant ? "did you mean '" + std::string(*meant) + "'?"
                       : "write for example 'expect = \"reef knot\"'; docs/scene.md lists all");
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

Result<void> check_expected_knot(const Scene& scene, const RibbonMesh& drawn) {
  if (!scene.knot) return {};
  const KnotScene& knot = *scene.knot;
  if (auto known = check_name(knot); !known) return known;
  if (is_called(drawn.crossings, knot.expect)) return {};
  return failure(knot.place,
                 "the drawing ties: " + text_of_knot(diagram_of(drawn.crossings)) +
                     "; expected is: " + knot.expect,
                 remedy_for(knot.expect, drawn));
}

Result<void> check_first_frame(const RibbonMesh& drawn, const Eigen::Matrix3Xd& start) {
  const auto as_drawn = closed_type(diagram_of(drawn.crossings));
  if (!as_drawn) return {};
  KnotWitness witness(drawn.grid, std::nullopt);
  witness.follow(start.cast<float>());
  const KnotCertificate certificate = witness.certificate();
  if (!certificate.jones || certificate.jones == as_drawn) return {};
  return failure("",
                 "the ribbon at its start is tied as: " + knot_text(*certificate.jones) +
                     "; its drawing as: " + knot_text(*as_drawn),
                 "lead both ends of the drawing straight out, and leave more room between the "
                 "strands");
}

}  // namespace ribbon
