#include "scene/outside_quotes.h"

#include <algorithm>
#include <string>

namespace ribbon {

namespace {

// Behind the string that begins at `begin`, or behind its line where it has no end.
std::size_t end_of_string(std::string_view toml, std::size_t begin) {
  const char quote = toml[begin];
  const bool is_long = toml.substr(begin, 3) == std::string(3, quote);
  const std::string_view end = toml.substr(begin, is_long ? 3 : 1);
  std::size_t at = begin + end.size();
  for (; at < toml.size() && toml.substr(at, end.size()) != end; ++at) {
    if (!is_long && toml[at] == '\n') return at;
    if (quote == '"' && toml[at] == '\\') ++at;
  }
  return std::min(at + end.size(), toml.size());
}

}  // namespace

std::optional<std::size_t> first_outside_quotes(std::string_view toml) {
  std::size_t at = toml.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  while (at < toml.size()) {
    const char letter = toml[at];
    if (static_cast<unsigned char>(letter) > 0x7F) return at;
    if (letter == '#')
      at = std::min(toml.find('\n', at), toml.size());
    else if (letter == '"' || letter == '\'')
      at = end_of_string(toml, at);
    else
      ++at;
  }
  return std::nullopt;
}

}  // namespace ribbon
