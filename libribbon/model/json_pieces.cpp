#include "model/json_pieces.h"

#include <array>
#include <cstddef>

#include "model/float_digits.h"
#include "text/json.h"

namespace ribbon {

std::string json_object(
    std::initializer_list<std::pair<std::string_view, std::string_view>> members) {
  std::size_t length = 1;
  for (const auto& [name, value] : members) length += name.size() + value.size() + 4;
  std::string text;
  text.reserve(length);
  for (const auto& [name, value] : members) {
    if (value.empty()) continue;
    text += text.empty() ? "{\"" : ",\"";
    text.append(name).append("\":").append(value);
  }
  return std::move(text += '}');
}

std::string json_quoted(std::string_view words) {
  std::string text = Json(words).text();
  text.pop_back();  // the line feed
  return text;
}

std::string json_number(float number) {
  constexpr std::size_t longest = 16;
  std::array<char, float_digits_room> digits;
  std::string text(digits.data(), write_digits(digits.data(), number));
  text.resize(longest, ' ');
  return text;
}

int JsonList::add(std::string_view value) {
  if (size_ > 0) text_ += ',';
  text_ += value;
  return size_++;
}

}  // namespace ribbon
