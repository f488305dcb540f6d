// The text of a scene, parsed: its tables and where things stand in the file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "result/result.h"
#include "scene/line_origins.h"
#include "scene/toml.h"

namespace ribbon {

struct Document {
  std::filesystem::path file;
  TomlValue root;                          // a table
  std::vector<LineOrigin> origins = {};    // of all lines; none where they are those of the file
  std::vector<std::string> settings = {};  // that these name

  // The table of that name, the whole file for the empty name; null when there is none. Of several
  // tables of one name "stage[2]" is the second, and "stage[2].hand[1]" the first in that.
  [[nodiscard]] const TomlValue* find(std::string_view table) const;
  // The key of a table; null when there is none.
  [[nodiscard]] const TomlValue* find(std::string_view table, std::string_view key) const;

  // "knot.toml:4:9", or "knot.toml with 'time.step=1'" where a setting wrote the line; the file
  // alone where TOML only implies it.
  [[nodiscard]] std::string place(const TomlPosition& position) const;
  // Of the key, else of its table, else of the file.
  [[nodiscard]] std::string place(std::string_view table, std::string_view key) const;
};

// Fails with the place where the text is no TOML.
Result<Document> parse_document(const std::filesystem::path& file, std::string_view text);

// In quotes and on one line, whatever stands in it.
std::string in_quotes(std::string_view text);

}  // namespace ribbon
