#include "text/json.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace ribbon {

struct Json::Value {
  nlohmann::ordered_json json;
};

Json::Json(std::nullptr_t) : value_(new Value{nullptr}) {}
Json::Json(bool value) : value_(new Value{value}) {}
Json::Json(double number) : value_(new Value{number}) {}
Json::Json(std::uint64_t number) : value_(new Value{number}) {}
Json::Json(Integer integer) : value_(new Value{integer.number}) {}
Json::Json(std::string_view text) : value_(new Value{text}) {}

Json::Json(std::initializer_list<Member> members) : Json() {
  for (const Member& member : members) set(member.name, member.value);
}

Json Json::list(std::initializer_list<Json> elements) {
  Json list;
  list.value_->json = nlohmann::ordered_json::array();
  for (const Json& element : elements) list.add(element);
  return list;
}

Json::Json(const Json& other) : value_(new Value(*other.value_)) {}
Json::Json(Json&& other) noexcept = default;
Json& Json::operator=(Json other) noexcept {
  std::swap(value_, other.value_);
  return *this;
}
Json::~Json() = default;

void Json::set(std::string_view name, Json value) {
  value_->json[std::string(name)] = std::move(value.value_->json);
}

void Json::add(Json element) {
  value_->json.push_back(std::move(element.value_->json));
}

std::string Json::text() const {
  return value_->json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

std::string Json::line() const {
  return value_->json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace ribbon
