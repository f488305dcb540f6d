// The part of CSS that drawing programs write into SVG files: rules that set properties of elements
// by their name, class or id (Cascading Style Sheets, level 2.1).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ribbon {

// An element of a drawing as rules see it. Each text is as it stands in the file.
struct StyledElement {
  std::string_view name;     // without a prefix
  std::string_view id;       // of its `id` attribute, and so on; empty: none
  std::string_view classes;  // words between blanks
  std::string_view style;    // declarations
};

// "stroke: Red !important", without blanks and in lower case.
struct Declaration {
  std::string property;
  std::string value;
  bool is_important = false;
};

class StyleSheet {
 public:
  StyleSheet() = default;  // without rules

  // The rules of the texts of a drawing's <style> elements, in their order, as far as they set one
  // of `properties` (lower case). What stands in an @ rule, as of other media, is left out.
  StyleSheet(std::string_view css, const std::vector<std::string_view>& properties);

  // The first of the selectors that set one of the properties and are more than names, classes and
  // ids of one element ("g > path"): whom they mean is not followed. Nothing: there are none, but
  // for what is said of an element while someone points at it.
  [[nodiscard]] const std::optional<std::string>& not_followed() const { return not_followed_; }

  // What `property` (one of those told) is by the rules and the element's own `style`, in lower
  // case and without blanks; nothing if neither sets it.
  [[nodiscard]] std::optional<std::string> value_of(std::string_view property,
                                                    const StyledElement& element) const;

 private:
  // What an element must have. None of it: any element.
  struct Selector {
    std::string name;
    std::vector<std::string> ids;
    std::vector<std::string> classes;
  };
  struct Rule {
    Selector selector;
    std::vector<Declaration> declarations;
  };

  static std::optional<Selector> read_selector(std::string_view text);
  static bool means(const Selector& selector, const StyledElement& element);
  void add_rule(std::string_view selectors, const std::vector<Declaration>& declarations);

  std::vector<Rule> rules_;
  std::optional<std::string> not_followed_;
};

}  // namespace ribbon
