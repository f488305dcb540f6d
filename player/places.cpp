#include "player/places.h"

#include <algorithm>
#include <optional>

#include "text/number_in.h"

namespace ribbon {

namespace {

std::optional<double> share_in(const std::string& text) {
  const auto number = number_in<double>(text);
  return number && *number >= 0 && *number <= 1 ? number : std::nullopt;
}

std::string remedy(const std::vector<RecordedMark>& marks) {
  std::string names;
  for (const RecordedMark& mark : marks) names += (names.empty() ? "'" : ", '") + mark.name + "'";
  return names.empty() ? "write a share of the ribbon's length from 0 to 1; this recording has no "
                         "marks, which are circles with an id in its drawing"
                       : "write a share of the ribbon's length from 0 to 1, or one of " + names;
}

Result<double> share_of(const std::vector<RecordedMark>& marks, const std::string& place) {
  const auto mark = std::ranges::find(marks, place, &RecordedMark::name);
  if (mark != marks.end()) return mark->share;
  if (const auto share = share_in(place)) return *share;
  return failure("--between " + place, "is no place of the ribbon", remedy(marks));
}

}  // namespace

Result<std::array<double, 2>> shares_of(const std::vector<RecordedMark>& marks,
                                        const std::pair<std::string, std::string>& places) {
  const auto first = share_of(marks, places.first);
  if (!first) return tl::unexpected(first.error());
  return share_of(marks, places.second).map([&](double second) {
    return std::array{*first, second};
  });
}

}  // namespace ribbon
