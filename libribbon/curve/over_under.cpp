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
  if (list.letters.size() != 2 * points.size()) return wrong_length(points, list);
  const auto places = places_in_walk(points);
  std::vector<Crossing> crossings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const char first = list.letters[places[i][0]];
    if (first == list.letters[places[i][1]])
      return failure(list.place,
                     "passages " + std::to_string(places[i][0] + 1) + " and " +
                         std::to_string(places[i][1] + 1) + " meet at " +
                         coordinates(points[i].point) + " of the drawing, and both say " + first,
                     "write O for the one that passes over and U for the other");
    crossings.push_back(crossing_of(points[i], first == 'O'));
  }
  return crossings;
}

Result<std::vector<Crossing>> over_and_under(const std::vector<DoublePoint>& points,
                                             const CurveScene& scene) {
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
