#include "scene/line_origins.h"

#include <algorithm>
#include <iterator>

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
  for (std::size_t i = 0; i < origins.size(); ++i)
    origins[i].line = static_cast<std::uint32_t>(i + 1);
  return origins;
}

void trace_setting(const std::string& setting, std::string_view before, std::string_view after,
                   std::vector<LineOrigin>& origins) {
  const auto old_lines = lines_of(before);
  const auto new_lines = lines_of(after);
  const auto [old_begin, new_begin] =
      std::mismatch(old_lines.begin(), old_lines.end(), new_lines.begin(), new_lines.end());
  const auto [old_end, new_end] =
      std::mismatch(old_lines.rbegin(), std::make_reverse_iterator(old_begin), new_lines.rbegin(),
                    std::make_reverse_iterator(new_begin));
  const auto begin = origins.begin() + (old_begin - old_lines.begin());
  const auto end = origins.end() - (old_end - old_lines.rbegin());
  const auto written = static_cast<std::size_t>(new_end.base() - new_begin);
  origins.insert(origins.erase(begin, end), written, LineOrigin{.setting = setting});
}

}  // namespace ribbon
