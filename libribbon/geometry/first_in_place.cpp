#include "geometry/first_in_place.h"

#include <array>
#include <map>

namespace ribbon {

std::vector<int> first_in_place(const Eigen::Matrix3Xf& vertices) {
  std::map<std::array<float, 3>, int> places;
  std::vector<int> first;
  first.reserve(static_cast<std::size_t>(vertices.cols()));
  for (int v = 0; v < vertices.cols(); ++v)
    first.push_back(
        places.try_emplace({vertices(0, v), vertices(1, v), vertices(2, v)}, v).first->second);
  return first;
}

}  // namespace ribbon
