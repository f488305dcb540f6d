#include "scene/setting.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string_view>

#include "scene/document.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

struct Setting {
  std::string table;  // as Document::find() names it
  std::string key;
  std::string value;  // TOML
};

bool is_toml(const std::string& value) {
  const auto parsed = parse_document("", "it = " + value);
  return parsed && parsed->root.as<TomlTable>()->entries.size() == 1 &&
         value.find('\n') == std::string::npos;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool is_bare(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '_' || letter == '-';
  });
}

// "stage[2]"
bool is_counted_step(std::string_view step) {
  const std::size_t bracket = step.find('[');
  if (bracket == std::string_view::npos || bracket == 0 || !step.ends_with(']')) return false;
  const std::string_view number = step.substr(bracket + 1, step.size() - bracket - 2);
  return is_bare(step.substr(0, bracket)) && !number.empty() && number.size() <= 6 &&
         std::all_of(number.begin(), number.end(),
                     [](unsigned char letter) { return std::isdigit(letter) != 0; });
}

// "stage[2]" or "stage[2].hand[1]"
bool is_counted(std::string_view table) {
  for (std::size_t begin = 0; begin <= table.size();) {
    const std::size_t end = std::min(table.find('.', begin), table.size());
    if (!is_counted_step(table.substr(begin, end - begin))) return false;
    begin = end + 1;
  }
  return true;
}

std::optional<Setting> parse_setting(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos) return std::nullopt;
  const std::string name = trimmed(text.substr(0, equals));
  const auto dot = name.rfind('.');
  Setting setting{dot == std::string::npos ? "" : name.substr(0, dot),
                  dot == std::string::npos ? name : name.substr(dot + 1),
                  trimmed(text.substr(equals + 1))};
  if (setting.key.empty() || setting.value.empty() || !is_bare(setting.key) ||
      !(is_bare(setting.table) || is_counted(setting.table)))
    return std::nullopt;
  if (!is_toml(setting.value)) setting.value = '"' + setting.value + '"';
  return is_toml(setting.value) ? std::optional(setting) : std::nullopt;
}

// Where the text begins behind a byte order mark, as some editors write one.
std::size_t begin_of(const std::string& text) {
  return text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

// Where a line and column, both from 1, stand in the text; columns count code points.
std::size_t offset_of(const std::string& text, const TomlPosition& position) {
  std::size_t offset = begin_of(text);
  for (std::uint32_t line = 1; line < position.line; ++line) offset = text.find('\n', offset) + 1;
  const auto is_continued = [&] {
    return offset < text.size() && (static_cast<unsigned char>(text[offset]) & 0xC0) == 0x80;
  };
  for (std::uint32_t column = 1; column < position.column; ++column) do {
      ++offset;
    } while (is_continued());
  return offset;
}

std::string changed_text(const Document& document, std::string text, const Setting& setting) {
  const std::string line = setting.key + " = " + setting.value;
  const TomlValue* table = document.find(setting.table);
  if (table == nullptr) {
    if (!text.empty() && text.back() != '\n') text += '\n';
    return text + "\n[" + setting.table + "]\n" + line + "\n";
  }
  if (const TomlValue* old = document.find(setting.table, setting.key)) {
    const std::size_t begin = offset_of(text, old->begin);
    return text.replace(begin, offset_of(text, old->end) - begin, setting.value);
  }
  if (setting.table.empty()) return text.insert(begin_of(text), line + "\n");
  const std::size_t end = text.find('\n', offset_of(text, table->begin));
  if (end == std::string::npos) return text + "\n" + line + "\n";
  return text.insert(end + 1, line + "\n");
}

tl::unexpected<Error> no_place_for(const std::string& what, const std::filesystem::path& file) {
  return failure(file.string(), "there is no place for " + what + " in the scene",
                 "write the tables of the scene as '[table]' lines");
}

}  // namespace

std::string setting_of(const std::string& key, double value) {
  return key + " = " + shortest(value);
}

Result<std::string> with_setting(const std::filesystem::path& file, const std::string& text,
                                 const std::string& setting) {
  const auto wanted = parse_setting(setting);
  if (!wanted)
    return failure("", in_quotes(setting) + " is not a setting",
                   "write for example 'fastening.speed=0.3'");
  const auto before = parse_document(file, text);
  if (!before) return tl::unexpected(before.error());
  if (is_counted(wanted->table) && before->find(wanted->table) == nullptr)
    return failure(file.string(), "there is no '" + wanted->table + "' in the scene",
                   "count its tables from 1, as they stand there");
  std::string changed = changed_text(*before, text, *wanted);
  const auto after = parse_document(file, changed);
  if (!after || after->find(wanted->table, wanted->key) == nullptr)
    return no_place_for(in_quotes(setting), file);
  return changed;
}

Result<std::string> with_entry_replaced(const std::filesystem::path& file, const std::string& text,
                                        std::string_view table, std::string_view key,
                                        const std::string& words) {
  const auto before = parse_document(file, text);
  if (!before) return tl::unexpected(before.error());
  const TomlValue* found = before->find(table);
  if (found == nullptr || found->as<TomlTable>() == nullptr) return text;
  const auto& entries = found->as<TomlTable>()->entries;
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const TomlEntry& candidate) { return candidate.key == key; });
  if (entry == entries.end()) return text;
  const std::size_t begin = offset_of(text, entry->key_begin);
  std::string changed = text;
  changed.replace(begin, offset_of(text, entry->value.end) - begin, words);
  if (!parse_document(file, changed)) return no_place_for(in_quotes(key), file);
  return changed;
}

}  // namespace ribbon
