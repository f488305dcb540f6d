// The part of CSS that drawing programs write into SVG files: rules that set properties of elements
// by their names, classes and ids, and by what they are in (Cascading Style Sheets, level 2.1).
#pragma once

#include <array>
#include <cstddef>
#include <functional>
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
  std::function<std::optional<StyledElement>()> parent;  // empty: it is in none
};

// "stroke: Red !important", without blanks and in lower case.
struct Declaration {
  std::string property;
  std::string value;
  bool is_important = false;
};

// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);

// Is it one of the words between blanks?
bool is_word_of(std::string_view words, std::string_view word);

class StyleSheet {
 public:
  // Those that matter, in lower case.
  explicit StyleSheet(std::vector<std::string> properties);

  // Reads the rules of a <style> element, after those of the elements before it, as far as they set
  // one of the properties. Returns the first of the selectors (or @ rules) that would, but whom it
  // means is not followed: one by an attribute, a sibling or a place ("path:first-child"). Nothing:
  // there is none. What holds only in print, or while someone points at an element, is left out.
  std::optional<std::string> add(std::string_view css);

  // What `property` (one of those) is by the rules and the element's own `style`, in lower case and
  // without blanks; nothing if neither sets it. Of what it is in, a thousand levels are looked at.
  [[nodiscard]] std::optional<std::string> value_of(std::string_view property,
                                                    const StyledElement& element) const;

 private:
  // What an element must have. None of it: any element.
  struct Compound {
    std::string name;
    std::vector<std::string> ids;
    std::vector<std::string> classes;
  };
  using Family = std::vector<Compound>;  // each is the parent of the next: "g > path"
  using Selector = std::vector<Family>;  // each is somewhere in the one before: "#band path"
  using Specificity = std::array<std::size_t, 3>;  // how many ids, classes and names it has
  struct Rule {
    Selector selector;
    Specificity specificity;
    std::vector<Declaration> declarations;
  };

  static std::optional<Compound> read_compound(std::string_view text);
  static std::optional<Selector> read_selector(std::string_view text);
  static Specificity specificity_of(const Selector& selector);
  static bool fits(const Compound& compound, const StyledElement& element);
  static std::optional<StyledElement> head_of(const Family& family, const StyledElement& last);
  static bool means(const Selector& selector, const StyledElement& element);
  [[nodiscard]] std::vector<Declaration> wanted(std::string_view declarations) const;
  std::optional<std::string> add_block(std::string_view prelude, std::string_view block);
  std::optional<std::string> add_rule(std::string_view selectors, std::string_view declarations);

  std::vector<std::string> properties_;
  std::vector<Rule> rules_;
};

}  // namespace ribbon
