#include "scene/line_origins.h"

#include <algorithm>
#include <numeric>

namespace ribbon {

namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace

std::vector<LineOrigin> origins_in_file(std::string_view text) {
  std::vector<LineOrigin> origins(lines_of(text).size());
  std::iota(origins.begin(), origins.end(), 1);
  return origins;
}

void trace_setting(int n, std::string_view before, std::string_view after,
                   std::vector<LineOrigin>& origins) {
  const auto old_lines = lines_of(before);
  const auto new_lines = lines_of(after);
  const std::size_t fewer = std::min(old_lines.size(), new_lines.size());
  std::size_t first = 0;
  while (first < fewer && old_lines[first] == new_lines[first]) ++first;
  std::size_t last = 0;
  while (last < fewer - first &&
         old_lines[old_lines.size() - 1 - last] == new_lines[new_lines.size() - 1 - last])
    ++last;
  const auto begin = origins.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = origins.end() - static_cast<std::ptrdiff_t>(last);
  origins.insert(origins.erase(begin, end), new_lines.size() - first - last, -n);
}

}  // namespace ribbon
