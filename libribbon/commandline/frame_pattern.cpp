#include "commandline/frame_pattern.h"

#include <cassert>
#include <optional>

namespace ribbon {

namespace {

constexpr std::string_view opening = "{frame";

// The digits that "", ":01" to ":09" between "{frame" and "}" ask for, nothing for other texts.
std::optional<int> digits_asked_for(std::string_view format, int default_digits) {
  if (format.empty()) return default_digits;
  const bool width =
      format.size() == 3 && format.substr(0, 2) == ":0" && format[2] >= '1' && format[2] <= '9';
  return width ? std::optional(format[2] - '0') : std::nullopt;
}

}  // namespace

Result<FramePattern> FramePattern::parse(const std::string& text) {
  const std::size_t open = text.find(opening);
  if (open == std::string::npos)
    return failure("", "'" + text + "' has no place for the frame number",
                   "write '{frame:04}' where the number shall stand");
  if (text.find(opening, open + 1) != std::string::npos)
    return failure("", "'" + text + "' has more than one place for the frame number",
                   "write '{frame:04}' once");
  FramePattern pattern;
  const std::size_t format = open + opening.size();
  const std::size_t close = text.find('}', format);
  const auto digits = close == std::string::npos
                          ? std::nullopt
                          : digits_asked_for(std::string_view(text).substr(format, close - format),
                                             pattern.digits_);
  if (!digits)
    return failure("", "'" + text + "' has a malformed place for the frame number",
                   "write '{frame}', or '{frame:04}' with 1 to 9 instead of 4 for other widths");
  pattern.before_ = text.substr(0, open);
  pattern.after_ = text.substr(close + 1);
  pattern.digits_ = *digits;
  return pattern;
}

Result<FramePattern> FramePattern::parse(const std::string& text, int frame_count) {
  if (frame_count != 1 || text.find('{') != std::string::npos) return parse(text);
  FramePattern name;
  name.before_ = text;
  name.digits_ = 0;
  return name;
}

std::filesystem::path FramePattern::file(const std::string& word) const {
  return before_ + (digits_ == 0 ? "." : "") + word + after_;
}

std::filesystem::path FramePattern::file(int number) const {
  return before_ + digits_of(number) + after_;
}

std::string FramePattern::digits_of(int number) const {
  assert(number >= 0);
  if (digits_ == 0) return "";
  std::string digits = std::to_string(number);
  if (digits.size() < static_cast<std::size_t>(digits_))
    digits.insert(0, digits_ - digits.size(), '0');
  return digits;
}

}  // namespace ribbon
