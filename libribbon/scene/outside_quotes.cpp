#include "scene/outside_quotes.h"

#include <algorithm>
#include <cctype>
#include <string>

namespace ribbon {

namespace {

constexpr std::size_t most_dots_in_key = 16;

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
  at = std::min(at + end.size(), toml.size());
  // The last letters of a long string may be one or two quotes.
  for (int i = 0; is_long && i < 2 && at < toml.size() && toml[at] == quote; ++i) ++at;
  return at;
}

// Behind the comment, string or single letter that begins at `at`.
std::size_t behind(std::string_view toml, std::size_t at) {
  if (toml[at] == '#') return std::min(toml.find('\n', at), toml.size());
  return toml[at] == '"' || toml[at] == '\'' ? end_of_string(toml, at) : at + 1;
}

// A letter of a key, or what may stand between its parts.
bool is_within_key(char letter) {
  return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
         std::string_view("_-\"' \t").find(letter) != std::string_view::npos;
}

}  // namespace

std::optional<std::size_t> first_outside_quotes(std::string_view toml) {
  for (std::size_t at = toml.starts_with("\xEF\xBB\xBF") ? 3 : 0; at < toml.size();
       at = behind(toml, at))
    if (static_cast<unsigned char>(toml[at]) > 0x7F) return at;
  return std::nullopt;
}

std::optional<std::size_t> first_too_deep(std::string_view toml) {
  std::size_t dots = 0;
  for (std::size_t at = 0; at < toml.size(); at = behind(toml, at)) {
    if (toml[at] == '.' && ++dots > most_dots_in_key) return at;
    if (toml[at] != '.' && !is_within_key(toml[at])) dots = 0;
  }
  return std::nullopt;
}

}  // namespace ribbon
