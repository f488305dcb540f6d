#include "curve/style_sheet.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <tuple>
#include <utility>

namespace ribbon {

namespace {

constexpr std::string_view blanks = " \t\r\n\f";

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
    if (c == '\\') {
      ++i;  // what follows stands for itself
    } else if (quote != 0) {
      if (c == quote || c == '\n') quote = 0;  // CSS ends a string with its line
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
  const auto has = [&](std::string_view part) { return selector.find(part) != selector.npos; };
  return (has(":hover") || has(":focus") || has(":active")) && !has(":not(");
}

// Sets nothing of an element that is seen on a screen and lies still.
bool is_aside(std::string_view at_rule) {
  return at_rule == "@media print" || at_rule.starts_with("@font-face") ||
         at_rule.starts_with("@page") || at_rule.find("keyframes") != at_rule.npos;
}

bool is_of_a_name(char c) {
  const auto letter = static_cast<unsigned char>(c);
  return letter >= 0x80 || std::isalnum(letter) != 0 || c == '-' || c == '_';
}

std::optional<StyledElement> parent_of(const StyledElement& element) {
  return element.parent ? element.parent() : std::nullopt;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

bool is_word_of(std::string_view words, std::string_view word) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find_first_of(blanks), words.size());
    if (words.substr(0, end) == word) return true;
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return false;
}

StyleSheet::StyleSheet(std::vector<std::string> properties) : properties_(std::move(properties)) {}

std::optional<std::string> StyleSheet::add(std::string_view css) {
  const std::string bare = without_comments(css);
  std::string_view text = bare;
  std::optional<std::string> not_followed;
  while (!(text = trimmed(text)).empty()) {
    if (text.starts_with("<!--") || text.starts_with("-->")) {
      text.remove_prefix(text.front() == '<' ? 4 : 3);
      continue;
    }
    const std::size_t end = find_outside(text, text.front() == '@' ? "{;" : "{");
    const std::string_view prelude = trimmed(text.substr(0, end));
    const bool has_block = end < text.size() && text[end] == '{';
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!has_block) continue;
    const auto unknown = add_block(prelude, take_block(text));
    if (!not_followed) not_followed = unknown;
  }
  return not_followed;
}

std::optional<std::string> StyleSheet::add_block(std::string_view prelude, std::string_view block) {
  if (!prelude.starts_with('@')) return add_rule(prelude, block);
  if (is_aside(prelude)) return std::nullopt;
  StyleSheet within(properties_);
  return within.add(block) || !within.rules_.empty() ? std::optional<std::string>(prelude)
                                                     : std::nullopt;
}

std::vector<Declaration> StyleSheet::wanted(std::string_view declarations) const {
  std::vector<Declaration> read = read_declarations(declarations);
  std::erase_if(read, [&](const Declaration& one) {
    return std::find(properties_.begin(), properties_.end(), one.property) == properties_.end();
  });
  return read;
}

std::optional<std::string> StyleSheet::add_rule(std::string_view selectors,
                                                std::string_view declarations) {
  const std::vector<Declaration> read = wanted(declarations);
  if (read.empty()) return std::nullopt;
  std::optional<std::string> not_followed;
  while (!selectors.empty()) {
    const std::string_view text = trimmed(take_until(selectors, ","));
    const auto selector = read_selector(text);
    if (selector)
      rules_.push_back({*selector, specificity_of(*selector), read});
    else if (!not_followed && !is_of_a_moment(text))
      not_followed = std::string(text);
  }
  return not_followed;
}

std::optional<StyleSheet::Compound> StyleSheet::read_compound(std::string_view text) {
  Compound compound;
  const auto take_name = [&text] {
    std::size_t length = 0;
    while (length < text.size() && is_of_a_name(text[length])) ++length;
    std::string name(text.substr(0, length));
    text.remove_prefix(length);
    return name;
  };
  if (text.starts_with('*'))
    text.remove_prefix(1);
  else
    compound.name = take_name();
  while (!text.empty()) {
    const char kind = text.front();
    text.remove_prefix(1);
    std::string name = take_name();
    if ((kind != '.' && kind != '#') || name.empty()) return std::nullopt;
    (kind == '#' ? compound.ids : compound.classes).push_back(std::move(name));
  }
  return compound;
}

std::optional<StyleSheet::Selector> StyleSheet::read_selector(std::string_view text) {
  Selector selector;
  bool goes_on = false;  // behind ">"
  while (!(text = trimmed(text)).empty()) {
    if (text.front() == '>') {
      if (goes_on || selector.empty()) return std::nullopt;
      goes_on = true;
      text.remove_prefix(1);
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" \t\r\n\f>"), text.size());
    const auto compound = read_compound(text.substr(0, end));
    if (!compound) return std::nullopt;
    if (!goes_on) selector.emplace_back();
    selector.back().push_back(*compound);
    goes_on = false;
    text.remove_prefix(end);
  }
  return selector.empty() || goes_on ? std::nullopt : std::optional(selector);
}

StyleSheet::Specificity StyleSheet::specificity_of(const Selector& selector) {
  Specificity specificity{};
  for (const Family& family : selector)
    for (const Compound& compound : family) {
      specificity[0] += compound.ids.size();
      specificity[1] += compound.classes.size();
      specificity[2] += compound.name.empty() ? 0 : 1;
    }
  return specificity;
}

bool StyleSheet::fits(const Compound& compound, const StyledElement& element) {
  return (compound.name.empty() || compound.name == element.name) &&
         std::all_of(compound.ids.begin(), compound.ids.end(),
                     [&](const std::string& id) { return id == element.id; }) &&
         std::all_of(compound.classes.begin(), compound.classes.end(),
                     [&](const std::string& name) { return is_word_of(element.classes, name); });
}

// The first of a family whose last one is this element; nothing where it is not.
std::optional<StyledElement> StyleSheet::head_of(const Family& family, const StyledElement& last) {
  std::optional<StyledElement> element = last;
  for (auto compound = family.rbegin(); compound != family.rend(); ++compound) {
    if (compound != family.rbegin()) element = parent_of(*element);
    if (!element || !fits(*compound, *element)) return std::nullopt;
  }
  return element;
}

// Of each family the nearest above will do: it leaves the most to the others.
bool StyleSheet::means(const Selector& selector, const StyledElement& element) {
  constexpr int most_levels = 1000;
  auto head = head_of(selector.back(), element);
  int levels = 0;
  for (auto family = selector.rbegin() + 1; head && family != selector.rend(); ++family) {
    auto above = parent_of(*head);
    head.reset();
    for (; above && !head && levels < most_levels; ++levels) {
      head = head_of(*family, *above);
      if (!head) above = parent_of(*above);
    }
  }
  return head.has_value();
}

// The cascade (CSS 2.1, 6.4): the important before others, the element's own style before rules,
// ids before classes before names, the later before the earlier.
std::optional<std::string> StyleSheet::value_of(std::string_view property,
                                                const StyledElement& element) const {
  using Weight = std::tuple<bool, bool, Specificity>;
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
        weigh(one, {one.is_important, false, rule.specificity});
  for (const Declaration& one : read_declarations(without_comments(element.style)))
    weigh(one, {one.is_important, true, {}});
  return value;
}

}  // namespace ribbon
