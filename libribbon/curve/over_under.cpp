#include "curve/over_under.h"

#include <algorithm>
#include <array>
#include <string>

#include "curve/place.h"

namespace ribbon {

namespace {

// Of each double point, which passages of the walk meet there, from 0.
std::vector<std::array<std::size_t, 2>> places_in_walk(const std::vector<DoublePoint>& points) {
  std::vector<std::pair<double, std::size_t>> visits;
  for (std::size_t i = 0; i < points.size(); ++i) {
    visits.emplace_back(points[i].first, 2 * i);
    visits.emplace_back(points[i].second, 2 * i + 1);
  }
  std::sort(visits.begin(), visits.end());
  std::vector<std::array<std::size_t, 2>> places(points.size());
  for (std::size_t k = 0; k < visits.size(); ++k)
    places[visits[k].second / 2][visits[k].second % 2] = k;
  return places;
}

// Of the letters of the list that tell of crossings, where in the list they stand.
std::vector<std::size_t> crossing_letters(const CrossingList& list) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < list.letters.size(); ++k)
    if (list.letters[k] == 'O' || list.letters[k] == 'U') places.push_back(k);
  return places;
}

Crossing crossing_of(const DoublePoint& point, bool first_over) {
  return {point.first, point.second, point.point, first_over,
          first_over ? point.sign_if_first_is_over : -point.sign_if_first_is_over};
}

// The point of a passage, from 0.
Eigen::Vector2d point_of(const std::vector<DoublePoint>& points, std::size_t passage) {
  const auto places = places_in_walk(points);
  std::size_t i = 0;
  while (places[i][0] != passage && places[i][1] != passage) ++i;
  return points[i].point;
}

tl::unexpected<Error> wrong_length(const std::vector<DoublePoint>& points,
                                   const CrossingList& list) {
  const std::size_t passages = 2 * points.size();
  const std::size_t letters = list.letters.size();
  std::string problem = "the drawing has " + std::to_string(passages) +
                        " passages, 'crossings' has " + std::to_string(letters) +
                        (letters == 1 ? " letter" : " letters");
  if (passages == 0)
    return failure(list.place, problem, "remove 'crossings': the drawing does not cross itself");
  const std::size_t passage = std::min(letters, passages - 1);
  problem += "; passage " + std::to_string(passage + 1) + " is at " +
             coordinates(point_of(points, passage));
  return failure(list.place, problem,
                 "write one letter for each passage, in the order of the walk");
}

bool is_in(std::size_t segment, double parameter) {
  return parameter >= static_cast<double>(segment) && parameter <= static_cast<double>(segment + 1);
}

bool is_in_gap(const JoinedDrawing& drawing, double parameter) {
  return std::any_of(drawing.gaps.begin(), drawing.gaps.end(),
                     [&](std::size_t gap) { return is_in(gap, parameter); });
}

Result<void> each_gap_passes_under_one(const std::vector<DoublePoint>& points,
                                       const JoinedDrawing& drawing) {
  for (const std::size_t gap : drawing.gaps) {
    const auto count = std::count_if(points.begin(), points.end(), [&](const DoublePoint& point) {
      return is_in(gap, point.first) || is_in(gap, point.second);
    });
    if (count == 1) continue;
    const Eigen::Vector2d middle = (drawing.points[gap] + drawing.points[gap + 1]) / 2;
    return failure(drawing_place(middle),
                   count == 0 ? "this gap passes under nothing"
                              : "this gap passes under " + std::to_string(count) + " strands",
                   count == 0 ? "join its two ends, or draw the strand that passes over it"
                              : "leave a gap of its own at each of them");
  }
  return {};
}

}  // namespace

// Each crossing is met once at an even and once at an odd place of the walk, unless an end of the
// curve is shut in by a loop of it.
Result<std::vector<Crossing>> alternating(const std::vector<DoublePoint>& points, bool first_over) {
  const auto places = places_in_walk(points);
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (places[i][0] % 2 == places[i][1] % 2)
      return failure(drawing_place(points[i].point),
                     "over and under cannot alternate: this crossing would be met twice on the "
                     "same side",
                     "lead the ends of the curve out of its loops, or say by 'crossings' in the "
                     "scene's [curve] what passes over");
    crossings.push_back(crossing_of(points[i], (places[i][0] % 2 == 0) == first_over));
  }
  return crossings;
}

Result<std::vector<Crossing>> as_listed(const std::vector<DoublePoint>& points,
                                        const CrossingList& list) {
  const std::vector<std::size_t> letters = crossing_letters(list);
  if (letters.size() != 2 * points.size()) return wrong_length(points, list);
  const auto places = places_in_walk(points);
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t first_letter = letters[places[i][0]];
    const std::size_t second_letter = letters[places[i][1]];
    const char first = list.letters[first_letter];
    if (first == list.letters[second_letter])
      return failure(list.place,
                     "passages " + std::to_string(first_letter + 1) + " and " +
                         std::to_string(second_letter + 1) + " meet at " +
                         coordinates(points[i].point) + " of the drawing, and both say " + first,
                     "write O for the one that passes over and U for the other");
    crossings.push_back(crossing_of(points[i], first == 'O'));
  }
  return crossings;
}

Result<std::vector<Crossing>> as_gaps_say(const std::vector<DoublePoint>& points,
                                          const JoinedDrawing& drawing) {
  if (auto passed = each_gap_passes_under_one(points, drawing); !passed)
    return tl::unexpected(passed.error());
  std::vector<Crossing> crossings;
  for (const DoublePoint& point : points) {
    const bool first_under = is_in_gap(drawing, point.first);
    const bool second_under = is_in_gap(drawing, point.second);
    if (first_under == second_under)
      return failure(drawing_place(point.point),
                     first_under ? "both strands that cross here have a gap"
                                 : "two strands cross here, and neither has a gap",
                     first_under ? "close the gap of the one that passes over"
                                 : "leave a gap in the one that passes under");
    crossings.push_back(crossing_of(point, second_under));
  }
  return crossings;
}

Result<std::vector<Crossing>> over_and_under(const std::vector<DoublePoint>& points,
                                             const JoinedDrawing& drawing,
                                             const CurveScene& scene) {
  const bool is_drawn = !drawing.gaps.empty() || !drawing.depths.empty();
  if (scene.crossings && is_drawn)
    return failure(scene.crossings->place,
                   drawing.gaps.empty()
                       ? "the strokes of the drawing say already what passes behind the object"
                       : "the gaps of the drawing say already what passes under",
                   "remove 'crossings', or join the pieces of the drawing");
  if (is_drawn) return as_gaps_say(points, drawing);
  return scene.crossings ? as_listed(points, *scene.crossings)
                         : alternating(points, scene.first_passage_over);
}

std::vector<Passage> passages_along(const std::vector<Crossing>& crossings) {
  std::vector<Passage> passages;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Crossing& crossing = crossings[i];
    passages.push_back({crossing.first, i, crossing.first_over, crossing.point});
    passages.push_back({crossing.second, i, !crossing.first_over, crossing.point});
  }
  std::sort(passages.begin(), passages.end(),
            [](const Passage& a, const Passage& b) { return a.parameter < b.parameter; });
  return passages;
}

}  // namespace ribbon
