#include "scene/nearest_word.h"

#include <algorithm>
#include <array>
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
  // rows[0] is the row of distances from the first i letters of `a` to each beginning of `b`,
  // rows[1] and rows[2] the two rows before.
  std::array<std::vector<int>, 3> rows;
  rows.fill(std::vector<int>(b.size() + 1));
  std::iota(rows[0].begin(), rows[0].end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::rotate(rows.begin(), rows.begin() + 2, rows.end());
    rows[0][0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replaced = rows[1][j - 1] + (same_letter(a[i - 1], b[j - 1]) ? 0 : 1);
      rows[0][j] = std::min({replaced, rows[1][j] + 1, rows[0][j - 1] + 1});
      const bool swapped =
          i > 1 && j > 1 && same_letter(a[i - 1], b[j - 2]) && same_letter(a[i - 2], b[j - 1]);
      if (swapped) rows[0][j] = std::min(rows[0][j], rows[2][j - 2] + 1);
    }
  }
  return rows[0].back();
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
