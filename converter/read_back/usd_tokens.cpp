#include "converter/read_back/usd_tokens.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "converter/read_back/written_motion.h"

namespace ribbon {

namespace {

constexpr std::uint64_t piece_bytes = std::uint64_t{1} << 16U;
constexpr std::size_t longest_number = 64;
constexpr int deepest_value = 2;  // an array of tuples

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

bool ends_word(char c) {
  return is_space(c) || std::string_view("(){}[]=,\"").find(c) != std::string_view::npos;
}

}  // namespace

void UsdTokens::go_to(std::uint64_t place) {
  begin_ = place;
  at_ = 0;
  piece_ = bytes_.up_to(begin_, piece_bytes);
}

// What was read already makes way for as much again. False at the end of the file.
bool UsdTokens::refill() {
  const std::size_t left = piece_.size() - at_;
  go_to(place());
  return piece_.size() > left;
}

char UsdTokens::peek() {
  do {
    while (at_ < piece_.size() && is_space(piece_[at_])) ++at_;
    if (at_ < piece_.size()) return piece_[at_];
  } while (refill());
  return 0;
}

char UsdTokens::next() {
  return at_ < piece_.size() || refill() ? piece_[at_++] : '\0';
}

bool UsdTokens::take_if(char mark) {
  if (peek() != mark) return false;
  ++at_;
  return true;
}

void UsdTokens::take(char mark) {
  if (!take_if(mark)) throw Spoiled(std::string("no '") + mark + "' where one should be");
}

std::string UsdTokens::word() {
  peek();
  std::string word;
  do {
    while (at_ < piece_.size() && !ends_word(piece_[at_])) word += piece_[at_++];
  } while (at_ == piece_.size() && refill());
  demand(!word.empty(), "no word where one should be");
  return word;
}

std::string UsdTokens::string() {
  take('"');
  std::string text;
  for (char c = next(); c != '"'; c = next()) {
    demand(c != 0, "a string without an end");
    text += c == '\\' ? next() : c;
  }
  return text;
}

void UsdTokens::skip_asset() {
  take('@');
  const bool is_short = next() != '@';
  demand(is_short || next() == '@', "a file without a name");
  const std::string_view end = is_short ? "@" : "@@@";
  for (std::string name; !name.ends_with(end);) {
    const char c = next();
    demand(c != 0, "a file's name without an end");
    name += c;
    if (name.ends_with("\\@@@")) name.clear();  // part of the name
  }
}

double UsdTokens::number() {
  peek();
  if (piece_.size() - at_ < longest_number) refill();
  double number = 0;
  const char* const begin = piece_.data() + at_;
  const auto [end, problem] = std::from_chars(begin, piece_.data() + piece_.size(), number);
  demand(problem == std::errc{} && std::isfinite(number), "no number where one should be");
  at_ += static_cast<std::size_t>(end - begin);
  return number;
}

void UsdTokens::value(std::vector<double>& numbers, int depth) {
  demand(depth <= deepest_value, "an array in an array");
  const char opening = peek();
  if (opening != '[' && opening != '(') {
    numbers.push_back(number());
    return;
  }
  const char closing = opening == '[' ? ']' : ')';
  ++at_;
  while (!take_if(closing)) {
    value(numbers, depth + 1);
    if (peek() != closing) take(',');
  }
}

// Numbers alone stand between them.
void UsdTokens::skip_array() {
  int depth = 0;
  do {
    demand(peek() != 0, "an array without an end");
    const char c = piece_[at_++];
    if (c == '[' || c == '(') ++depth;
    if (c == ']' || c == ')') --depth;
  } while (depth > 0);
}

}  // namespace ribbon
