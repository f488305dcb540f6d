#include "player/appearance.h"

#include <algorithm>

namespace ribbon {

namespace {

std::optional<Quantity> quantity_for(const std::string& word) {
  const auto* const found = std::find(quantity_words.begin(), quantity_words.end(), word);
  if (found == quantity_words.end()) return std::nullopt;
  return static_cast<Quantity>(found - quantity_words.begin());
}

}  // namespace

void add_appearance_options(Arguments& arguments, AppearanceTexts& texts) {
  const auto color_by = arguments
                            .add("--color-by", texts.color_by, "QUANTITY",
                                 "colour the ribbon by strain, speed, contact or gap, with a "
                                 "legend (default: its cloth)")
                            .one_of({quantity_words.begin(), quantity_words.end()});
  arguments
      .add("--color-range", texts.color_range, "A:B",
           "values of the first and the last colour, in the legend's unit (default: of the frames "
           "asked for)")
      .needs(color_by);
  arguments.add("--overlay", texts.overlays, "WORDS",
                "draw over the pictures: some of wireframe, obstacle-wireframe, curve, frame, "
                "time, numbers, with commas between them");
}

Result<Appearance> parse_appearance(const AppearanceTexts& texts, bool follows) {
  Appearance appearance;
  appearance.color_by = quantity_for(texts.color_by);
  const bool needs_largest =
      appearance.color_by == Quantity::strain || appearance.color_by == Quantity::speed;
  if (!texts.color_range.empty()) {
    const auto range = parse_color_range(texts.color_range, *appearance.color_by);
    if (!range) return tl::unexpected(range.error());
    appearance.color_range = *range;
  } else if (follows && needs_largest) {
    return failure("--color-by " + texts.color_by,
                   "needs to know its largest value, and --follow does not know what is to come",
                   "add --color-range A:B");
  }
  if (!texts.overlays.empty()) {
    const auto overlays = parse_overlays(texts.overlays);
    if (!overlays) return tl::unexpected(overlays.error());
    appearance.overlays = *overlays;
  }
  return appearance;
}

}  // namespace ribbon
