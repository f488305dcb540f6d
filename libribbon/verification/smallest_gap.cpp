#include "verification/smallest_gap.h"

#include <algorithm>
#include <limits>

#include "verification/feature_pair_search.h"

namespace ribbon {

namespace {

// Branch and bound: a pair of nodes whose boxes are further apart than the best gap so far holds no
// better one.
class Smallest {
 public:
  [[nodiscard]] double limit() const {
    return best_ ? best_->certain_m : std::numeric_limits<double>::infinity();
  }

  void take(double distance_m, const MeasuredPair& pair) {
    if (distance_m >= limit()) return;
    const auto [first, second] = std::minmax(pair.triangle, pair.other);
    best_ = {distance_m, {first, second}};
  }

  [[nodiscard]] const std::optional<SmallestGap>& best() const { return best_; }

 private:
  std::optional<SmallestGap> best_;
};

}  // namespace

std::optional<SmallestGap> smallest_gap(const TriangleSoup& soup, const FeatureOwners& owners,
                                        const BoxTree& judged, const BoxTree& rest) {
  Smallest smallest;
  FeaturePairSearch search(soup, owners, smallest);
  search_pairs(judged, rest, search);
  return smallest.best();
}

}  // namespace ribbon
