// JSON for programs that read what our tools found.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ribbon {

// One JSON value. Members of an object keep the order in which they were named.
class Json {
 public:
  struct Member;

  Json(std::nullptr_t = nullptr);
  Json(bool value);
  Json(double number);  // null where it is no finite number
  Json(std::integral auto number) : Json(Integer{static_cast<std::int64_t>(number)}) {}
  Json(std::uint64_t number);
  Json(std::string_view text);
  Json(const std::string& text) : Json(std::string_view(text)) {}
  Json(const char* text) : Json(std::string_view(text)) {}
  // Null where there is none.
  template <class T>
  Json(const std::optional<T>& value) : Json(value ? Json(*value) : Json()) {}
  template <class T>
  Json(const std::vector<T>& elements) : Json(list({})) {
    for (const T& element : elements) add(element);
  }
  // An object.
  Json(std::initializer_list<Member> members);
  static Json list(std::initializer_list<Json> elements);

  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(Json other) noexcept;
  ~Json();

  // A member more of an object (or of null, which becomes one).
  void set(std::string_view name, Json value);
  // An element more of a list.
  void add(Json element);

  // Two spaces a level, a line feed at the end. What is not UTF-8, as names of files need not be,
  // is replaced.
  [[nodiscard]] std::string text() const;
  // The same in one line, without its end.
  [[nodiscard]] std::string line() const;

 private:
  struct Integer {
    std::int64_t number;
  };
  struct Value;

  explicit Json(Integer integer);

  std::unique_ptr<Value> value_;
};

struct Json::Member {
  std::string_view name;
  Json value;
};

}  // namespace ribbon
