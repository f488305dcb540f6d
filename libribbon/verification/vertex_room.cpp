#include "verification/vertex_room.h"

#include <algorithm>
#include <utility>

#include "verification/feature_pair_search.h"

namespace ribbon {

namespace {

class Room {
 public:
  Room(Eigen::Index points, double reach_m)
      : reach_m_(reach_m), room_m_(static_cast<std::size_t>(points), reach_m) {}

  [[nodiscard]] double limit() const { return reach_m_; }

  void take(double distance_m, const MeasuredPair& pair) {
    for (const int vertex : pair.vertices) room_m_[vertex] = std::min(room_m_[vertex], distance_m);
  }

  [[nodiscard]] std::vector<double> of_points() && { return std::move(room_m_); }

 private:
  double reach_m_;
  std::vector<double> room_m_;
};

}  // namespace

std::vector<double> vertex_room(const TriangleSoup& soup, const FeatureOwners& owners,
                                const BoxTree& judged, const BoxTree& rest, double reach_m) {
  Room room(soup.points.cols(), reach_m);
  FeaturePairSearch search(soup, owners, room);
  search_pairs(judged, rest, search);
  return std::move(room).of_points();
}

}  // namespace ribbon
