#include "scene/nearest_word.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <utility>

namespace ribbon {

namespace {

bool same_letter(char a, char b) {
  return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
}

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  // `row` holds the distances from the first i letters of `a` to each beginning of `b`, the other
  // two those of the rows above it.
  std::vector<int> row(b.size() + 1);
  std::vector<int> above(b.size() + 1);
  std::vector<int> two_above(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_above.swap(above);
    above.swap(row);
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = above[j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      const bool swapped =
          i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]);
      if (swapped) row[j] = std::min(row[j], two_above[j - 2] + 1);
    }
  }
  return row.back();
}

std::optional<std::string_view> nearest_word(std::string_view typed,
                                             const std::vector<std::string_view>& words) {
  std::pair<int, std::optional<std::string_view>> best{
      std::max(1, static_cast<int>(typed.size() / 3)) + 1, std::nullopt};
  for (const std::string_view word : words) {
    const int distance = edit_distance(typed, word);
    if (distance < best.first) best = {distance, word};
  }
  return best.second;
}

}  // namespace ribbon
