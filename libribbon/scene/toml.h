// TOML as values that know where they stand. Nobody else sees the parser.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

namespace ribbon {

// Both from 1, columns in code points; line 0: nowhere, TOML only implies what is asked for.
struct TomlPosition {
  std::uint32_t line = 0;
  std::uint32_t column = 0;
};

struct TomlValue;
struct TomlEntry;

using TomlArray = std::vector<TomlValue>;

struct TomlTable {
  std::vector<TomlEntry> entries;  // by their keys

  // Null where there is none.
  [[nodiscard]] const TomlValue* find(std::string_view key) const;
};

struct TomlMoment {};  // a date or time

struct TomlValue {
  std::variant<TomlMoment, bool, std::int64_t, double, std::string, TomlArray, TomlTable> value;
  TomlPosition begin;  // of a [table]: its line
  TomlPosition end;

  // Null where it is of another kind.
  template <class Kind>
  [[nodiscard]] const Kind* as() const {
    return std::get_if<Kind>(&value);
  }
};

struct TomlEntry {
  std::string key;
  TomlPosition key_begin;
  TomlValue value;
};

struct TomlProblem {
  std::string sentence;
  TomlPosition position;
};

// The whole file as a value that holds its table.
tl::expected<TomlValue, TomlProblem> parse_toml(std::string_view text);

}  // namespace ribbon
