// Triangle soups for the tests of verification.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <initializer_list>
#include <random>
#include <set>
#include <vector>

#include "verification/triangle_soup.h"
#include "verification/triangles_meet.h"

namespace ribbon {

using Points = std::initializer_list<Eigen::Vector3f>;

// A soup of which all triangles are judged.
inline TriangleSoup soup_of(Points points, std::initializer_list<Eigen::Vector3i> triangles) {
  TriangleSoup soup{{3, static_cast<Eigen::Index>(points.size())},
                    {3, static_cast<Eigen::Index>(triangles.size())},
                    static_cast<int>(triangles.size())};
  Eigen::Index column = 0;
  for (const auto& point : points) soup.points.col(column++) = point;
  column = 0;
  for (const auto& triangle : triangles) soup.triangles.col(column++) = triangle;
  return soup;
}

// How the coordinates of a random soup are chosen.
struct Coordinates {
  int lowest = -8;
  int highest = 8;
  float unit = 1;
};

// `triangles` triangles over `points` points with whole coordinates, so that touching, coplanar and
// degenerate triangles are frequent. Triangles have three different vertices.
inline TriangleSoup random_soup(unsigned seed, int points, int triangles,
                                const Coordinates& coordinates) {
  std::mt19937 random(seed);
  const auto below = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  TriangleSoup soup{{3, points}, {3, triangles}, triangles};
  for (float& coordinate : soup.points.reshaped())
    coordinate = static_cast<float>(coordinates.lowest +
                                    below(coordinates.highest - coordinates.lowest + 1)) *
                 coordinates.unit;
  for (int t = 0; t < triangles; ++t) {
    std::set<int> corners;
    while (corners.size() < 3) corners.insert(below(points));
    std::copy(corners.begin(), corners.end(), soup.triangles.col(t).begin());
  }
  return soup;
}

// Calls visit for every pair that the soup's rules say is verified, without any tree.
inline void for_every_pair(const TriangleSoup& soup,
                           const std::function<void(const TrianglePair&)>& visit) {
  for (int first = 0; first < soup.judged; ++first)
    for (int second = first + 1; second < soup.triangles.cols(); ++second) visit({first, second});
}

inline std::vector<TrianglePair> brute_force_pairs(const TriangleSoup& soup) {
  std::vector<TrianglePair> pairs;
  for_every_pair(soup, [&](const TrianglePair& pair) {
    if (triangles_meet(soup, pair)) pairs.push_back(pair);
  });
  return pairs;
}

}  // namespace ribbon
