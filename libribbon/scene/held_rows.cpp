#include "scene/held_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>

namespace ribbon {

std::vector<HeldRows> held_rows(std::span<const Span> spans, int along) {
  const auto row = [along](double share) {
    return static_cast<int>(std::lround(share * (along - 1)));
  };
  std::vector<HeldRows> held;
  for (const Span& span : spans) held.push_back({row(span.begin), row(span.end)});
  std::vector<std::size_t> order(spans.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [spans](std::size_t a, std::size_t b) {
    return std::tie(spans[a].begin, spans[a].end) < std::tie(spans[b].begin, spans[b].end);
  });
  for (std::size_t i = 1; i < order.size(); ++i) {
    HeldRows& before = held[order[i - 1]];
    HeldRows& after = held[order[i]];
    if (before.last < after.first) continue;
    if (before.count() > 1)
      before.last = after.first - 1;
    else
      after.first = before.last + 1;
  }
  return held;
}

}  // namespace ribbon
