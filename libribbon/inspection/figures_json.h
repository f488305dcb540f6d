// Figures of a recording that several tools tell to programs.
#pragma once

#include <optional>

#include "inspection/outcome.h"
#include "recording/records/recording.h"
#include "text/json.h"

namespace ribbon {

// Objects; null where there is none.
Json tightness_json(const std::optional<TightnessNumbers>& tightness);
Json outcome_json(const std::optional<Outcome>& outcome);

}  // namespace ribbon
