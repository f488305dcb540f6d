// How pictures show a frame: what the ribbon is coloured by, and what is drawn over it.
#pragma once

#include <optional>
#include <string>

#include "commandline/arguments.h"
#include "player/measure/quantity.h"
#include "player/overlay/overlays.h"
#include "result/result.h"

namespace ribbon {

struct Appearance {
  std::optional<Quantity> color_by;       // nothing: the ribbon shows its cloth
  std::optional<ValueRange> color_range;  // nothing: found out
  Overlays overlays;
};

// As users write it; empty: as it is without.
struct AppearanceTexts {
  std::string color_by;  // one of quantity_words
  std::string color_range;
  std::string overlays;
};

void add_appearance_options(Arguments& arguments, AppearanceTexts& texts);

// Fails when a text cannot be understood, and when a range would have to be found out of frames
// that are still to come.
Result<Appearance> parse_appearance(const AppearanceTexts& texts, bool follows);

}  // namespace ribbon
