#include "verification/intersecting_pairs.h"

#include <algorithm>
#include <utility>

#include "verification/triangles_meet.h"

namespace ribbon {

namespace {

class PairSearch {
 public:
  PairSearch(const TriangleSoup& soup, std::size_t most) : soup_(soup), most_(most) {}

  bool skips(const ClosedBox& box, const ClosedBox& other) {
    return !box.meets(other) || is_full();
  }

  void test(int a, int b) {
    if (!ClosedBox::around(soup_, a).meets(ClosedBox::around(soup_, b)) || is_full()) return;
    const TrianglePair pair{std::min(a, b), std::max(a, b)};
    if (triangles_meet(soup_, pair)) found_.pairs.push_back(pair);
  }

  IntersectingPairs found() {
    std::sort(found_.pairs.begin(), found_.pairs.end());
    return std::move(found_);
  }

 private:
  // Asked only where there is something left to test.
  bool is_full() {
    if (found_.pairs.size() >= most_) found_.all = false;
    return !found_.all;
  }

  const TriangleSoup& soup_;
  std::size_t most_;
  IntersectingPairs found_;
};

}  // namespace

IntersectingPairs intersecting_pairs(const TriangleSoup& soup, const BoxTree& judged,
                                     const BoxTree& rest, std::size_t most) {
  PairSearch search(soup, most);
  search_pairs(judged, rest, search);
  return search.found();
}

}  // namespace ribbon
