#include "scene/document.h"

#include <algorithm>
#include <charconv>

#include "scene/outside_quotes.h"

namespace ribbon {

namespace {

// In bytes: a letter beyond ASCII may stand before it, but the parser has not counted any.
TomlPosition position_at(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t begin = before.rfind('\n') + 1;  // 0 where there is none
  return {static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n') + 1),
          static_cast<std::uint32_t>(offset - begin + 1)};
}

// The table "name", or the one of several that "name[2]" counts, from 1; null where there is none.
const TomlValue* element(const TomlTable& table, std::string_view step) {
  const std::size_t bracket = std::min(step.find('['), step.size());
  const TomlValue* found = table.find(step.substr(0, bracket));
  if (found != nullptr && bracket < step.size()) {
    const auto* array = found->as<TomlArray>();
    std::size_t number = 0;
    std::from_chars(step.data() + bracket + 1, step.data() + step.size(), number);
    const bool is_there = array != nullptr && number >= 1 && number <= array->size();
    found = is_there ? &(*array)[number - 1] : nullptr;
  }
  return found != nullptr && found->as<TomlTable>() != nullptr ? found : nullptr;
}

}  // namespace

const TomlValue* Document::find(std::string_view table) const {
  if (table.empty()) return &root;
  const TomlValue* found = &root;
  for (std::size_t begin = 0; found != nullptr && begin <= table.size();) {
    const std::size_t end = std::min(table.find('.', begin), table.size());
    found = element(*found->as<TomlTable>(), table.substr(begin, end - begin));
    begin = end + 1;
  }
  return found;
}

const TomlValue* Document::find(std::string_view table, std::string_view key) const {
  const TomlValue* found = find(table);
  return found == nullptr ? nullptr : found->as<TomlTable>()->find(key);
}

std::string Document::place(const TomlPosition& position) const {
  if (position.line == 0) return file.string();
  const LineOrigin origin = position.line <= origins.size() ? origins[position.line - 1]
                                                            : static_cast<int>(position.line);
  if (origin <= 0) return file.string() + " with " + in_quotes(settings[-origin]);
  return file.string() + ":" + std::to_string(origin) + ":" + std::to_string(position.column);
}

std::string Document::place(std::string_view table, std::string_view key) const {
  if (const TomlValue* value = find(table, key)) return place(value->begin);
  const TomlValue* found = find(table);
  return found == nullptr ? file.string() : place(found->begin);
}

Result<Document> parse_document(const std::filesystem::path& file, std::string_view text) {
  Document document{file, {}};
  if (const auto letter = first_outside_quotes(text))
    return failure(document.place(position_at(text, *letter)),
                   "a letter that is not plain ASCII stands outside of quotes",
                   "put the text that it belongs to in quotes");
  if (const auto dot = first_too_deep(text))
    return failure(document.place(position_at(text, *dot)),
                   "a key goes deeper than there are tables in a scene",
                   "name a table and a key, as in 'ribbon.width'");
  auto parsed = parse_toml(text);
  if (!parsed)
    return failure(document.place(parsed.error().position), parsed.error().sentence,
                   "correct the TOML here");
  document.root = *std::move(parsed);
  return document;
}

std::string in_quotes(std::string_view text) {
  std::string line = "'";
  line.append(text).append("'");
  std::replace_if(
      line.begin(), line.end(), [](unsigned char letter) { return letter < ' ' || letter == 127; },
      '?');
  return line;
}

}  // namespace ribbon
