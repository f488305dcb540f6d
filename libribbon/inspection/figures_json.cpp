#include "inspection/figures_json.h"

namespace ribbon {

Json tightness_json(const std::optional<TightnessNumbers>& tightness) {
  if (!tightness) return nullptr;
  Json json;
  for (const TightnessColumn& column : tightness_columns)
    json.set(column.name, (*tightness).*column.value);
  return json;
}

Json outcome_json(const std::optional<Outcome>& outcome) {
  if (!outcome) return nullptr;
  const auto& slipped = outcome->slipped_off;
  return {{"embraces_object", outcome->embraces_object},
          {"slipped_off",
           slipped ? Json{{"frame", slipped->frame}, {"time_s", slipped->time_s}} : Json()},
          {"knot_distance_m", outcome->knot_distance_m}};
}

}  // namespace ribbon
