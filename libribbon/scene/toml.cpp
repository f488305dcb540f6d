#include "scene/toml.h"

#include <algorithm>

#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

namespace ribbon {

namespace {

TomlPosition position_of(const toml::source_position& position) {
  return {position.line, position.column};
}

TomlValue value_of(const toml::node& node);

TomlArray array_of(const toml::array& nodes) {
  TomlArray array;
  for (const toml::node& node : nodes) array.push_back(value_of(node));
  return array;
}

TomlTable table_of(const toml::table& nodes) {
  TomlTable table;
  for (const auto& [key, node] : nodes)
    table.entries.push_back(
        {std::string(key.str()), position_of(key.source().begin), value_of(node)});
  return table;
}

TomlValue value_of(const toml::node& node) {
  TomlValue value{TomlMoment{}, position_of(node.source().begin), position_of(node.source().end)};
  if (const auto* truth = node.as_boolean()) value.value = truth->get();
  if (const auto* number = node.as_integer()) value.value = number->get();
  if (const auto* number = node.as_floating_point()) value.value = number->get();
  if (const auto* text = node.as_string()) value.value = text->get();
  if (const auto* array = node.as_array()) value.value = array_of(*array);
  if (const auto* table = node.as_table()) value.value = table_of(*table);
  return value;
}

}  // namespace

const TomlValue* TomlTable::find(std::string_view key) const {
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const TomlEntry& one) { return one.key == key; });
  return entry == entries.end() ? nullptr : &entry->value;
}

tl::expected<TomlValue, TomlProblem> parse_toml(std::string_view text) {
  try {
    return value_of(toml::parse(text));
  } catch (const toml::parse_error& problem) {
    return tl::unexpected(
        TomlProblem{std::string(problem.description()), position_of(problem.source().begin)});
  }
}

}  // namespace ribbon
