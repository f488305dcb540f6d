#include "curve/style_sheet.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace ribbon {

namespace {

constexpr std::string_view blanks = " \t\r\n\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string without_comments(std::string_view css) {
  std::string rest;
  while (true) {
    const std::size_t begin = css.find("/*");
    rest += css.substr(0, begin);
    if (begin == std::string_view::npos) return rest;
    const std::size_t end = css.find("*/", begin + 2);
    if (end == std::string_view::npos) return rest;
    css.remove_prefix(end + 2);
    rest += ' ';
  }
}

// The first of `wanted` outside of quotes and of parentheses, as in url("a;b"); otherwise the end.
std::size_t find_outside(std::string_view text, std::string_view wanted) {
  char quote = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (depth == 0 && wanted.find(c) != std::string_view::npos) {
      return i;
    } else if (c == '(') {
      ++depth;
    } else if (c == ')' && depth > 0) {
      --depth;
    }
  }
  return text.size();
}

// Takes what stands before the first of `ends` off the text, and that one too.
std::string_view take_until(std::string_view& text, std::string_view ends) {
  const std::size_t end = find_outside(text, ends);
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

// Takes a block's inside, of which the opening brace is taken already, and its closing brace.
std::string_view take_block(std::string_view& text) {
  const std::string_view whole = text;
  for (int depth = 1; depth > 0 && !text.empty();) {
    text.remove_prefix(find_outside(text, "{}"));
    if (text.empty()) return whole;
    depth += text.front() == '{' ? 1 : -1;
    text.remove_prefix(1);
  }
  return whole.substr(0, whole.size() - text.size() - 1);
}

std::string plain(std::string_view text) {
  std::string lower;
  for (const char c : text)
    if (blanks.find(c) == std::string_view::npos)
      lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

std::vector<Declaration> read_declarations(std::string_view text) {
  constexpr std::string_view important = "!important";
  std::vector<Declaration> declarations;
  while (!text.empty()) {
    std::string_view one = take_until(text, ";");
    Declaration next{plain(take_until(one, ":")), plain(one)};
    if (next.value.ends_with(important)) {
      next.value.resize(next.value.size() - important.size());
      next.is_important = true;
    }
    if (!next.value.empty()) declarations.push_back(next);
  }
  return declarations;
}

// Means elements only while someone points at them.
bool is_of_a_moment(std::string_view selector) {
  return selector.find(":hover") != std::string_view::npos ||
         selector.find(":focus") != std::string_view::npos ||
         selector.find(":active") != std::string_view::npos;
}

bool is_one_of(std::string_view word, std::string_view words) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find_first_of(blanks), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

}  // namespace

StyleSheet::StyleSheet(std::string_view css, const std::vector<std::string_view>& properties) {
  const std::string bare = without_comments(css);
  std::string_view text = bare;
  while (!(text = trimmed(text)).empty()) {
    if (text.starts_with("<!--") || text.starts_with("-->")) {
      text.remove_prefix(text.front() == '<' ? 4 : 3);
    } else if (text.front() == '@') {
      text.remove_prefix(find_outside(text, "{;"));
      const bool has_block = text.starts_with('{');
      text.remove_prefix(std::min<std::size_t>(1, text.size()));
      if (has_block) take_block(text);
    } else {
      const std::string_view selectors = take_until(text, "{");
      std::vector<Declaration> declarations = read_declarations(take_block(text));
      std::erase_if(declarations, [&](const Declaration& one) {
        return std::find(properties.begin(), properties.end(), one.property) == properties.end();
      });
      if (!declarations.empty()) add_rule(selectors, declarations);
    }
  }
}

void StyleSheet::add_rule(std::string_view selectors,
                          const std::vector<Declaration>& declarations) {
  while (!selectors.empty()) {
    const std::string_view text = trimmed(take_until(selectors, ","));
    const auto selector = read_selector(text);
    if (selector) rules_.push_back({*selector, declarations});
    if (!selector && !not_followed_ && !is_of_a_moment(text)) not_followed_ = std::string(text);
  }
}

std::optional<StyleSheet::Selector> StyleSheet::read_selector(std::string_view text) {
  if (text.empty() || text.find_first_of(" \t\r\n\f>+~:[\\") != std::string_view::npos)
    return std::nullopt;
  Selector selector;
  const std::size_t name_end = std::min(text.find_first_of(".#"), text.size());
  if (text.substr(0, name_end) != "*") selector.name = text.substr(0, name_end);
  text.remove_prefix(name_end);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(".#", 1), text.size());
    if (end == 1) return std::nullopt;
    (text.front() == '#' ? selector.ids : selector.classes).emplace_back(text.substr(1, end - 1));
    text.remove_prefix(end);
  }
  return selector;
}

bool StyleSheet::means(const Selector& selector, const StyledElement& element) {
  return (selector.name.empty() || selector.name == element.name) &&
         std::all_of(selector.ids.begin(), selector.ids.end(),
                     [&](const std::string& id) { return id == element.id; }) &&
         std::all_of(selector.classes.begin(), selector.classes.end(),
                     [&](const std::string& name) { return is_one_of(name, element.classes); });
}

// The cascade (CSS 2.1, 6.4): the important before others, the element's own style before rules,
// ids before classes before names, the later before the earlier.
std::optional<std::string> StyleSheet::value_of(std::string_view property,
                                                const StyledElement& element) const {
  using Weight = std::tuple<bool, bool, std::size_t, std::size_t, bool>;
  std::optional<std::string> value;
  Weight heaviest;
  const auto weigh = [&](const Declaration& declaration, const Weight& weight) {
    if (declaration.property != property || (value && weight < heaviest)) return;
    value = declaration.value;
    heaviest = weight;
  };
  for (const Rule& rule : rules_)
    if (means(rule.selector, element))
      for (const Declaration& one : rule.declarations)
        weigh(one, {one.is_important, false, rule.selector.ids.size(), rule.selector.classes.size(),
                    !rule.selector.name.empty()});
  for (const Declaration& one : read_declarations(without_comments(element.style)))
    weigh(one, {one.is_important, true, 0, 0, false});
  return value;
}

}  // namespace ribbon
