// The word that somebody who mistyped may have meant.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace ribbon {

// Letters to insert, remove, replace or swap with their neighbour until `a` reads as `b`; upper and
// lower case count as the same letter.
int edit_distance(std::string_view a, std::string_view b);

// The first of the words nearest to `typed`, when it is near enough to have been meant: at most one
// letter in three differs, though one always may.
std::optional<std::string_view> nearest_word(std::string_view typed,
                                             const std::vector<std::string_view>& words);

}  // namespace ribbon
