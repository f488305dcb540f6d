// JSON as text, put together from pieces: for what would be too large as a tree of values.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace ribbon {

// Each member's value is JSON already; empty: the object has no such member.
std::string json_object(
    std::initializer_list<std::pair<std::string_view, std::string_view>> members);

// Quoted, with what needs it escaped.
std::string json_quoted(std::string_view words);

// Always as long as the longest float, so that a number can take the place of another.
std::string json_number(float number);

// Others refer to its values by their indices.
class JsonList {
 public:
  // The value's index. value: JSON already.
  int add(std::string_view value);
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] std::string text() && { return std::move(text_ += ']'); }
  // Nothing where the list is empty: an object then has no such member.
  [[nodiscard]] std::string text_or_nothing() && {
    return size_ > 0 ? std::move(*this).text() : std::string();
  }

 private:
  std::string text_ = "[";
  int size_ = 0;
};

template <class Numbers>
std::string json_numbers(const Numbers& numbers) {
  JsonList list;
  for (const float number : numbers) list.add(json_number(number));
  return std::move(list).text();
}

}  // namespace ribbon
