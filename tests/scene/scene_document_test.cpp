// docs/scene.md against the reader: the same keys in the same tables, an example that is a scene.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "files/files.h"
#include "scene/scene_files.h"

namespace ribbon::scene_document_test {

using KeysOfTables = std::map<std::string, std::set<std::string>>;

std::string document() {
  return read_file(RIBBON_SCENE_DOCUMENT).value();
}

// What stands between `open` and `close` from `from` on; `from` moves behind it. Empty: none left.
std::string between(const std::string& text, std::size_t& from, const std::string& open,
                    const std::string& close) {
  const std::size_t begin = text.find(open, from);
  if (begin == std::string::npos) return "";
  const std::size_t end = text.find(close, begin + open.size());
  from = end + close.size();
  return text.substr(begin + open.size(), end - begin - open.size());
}

std::string example() {
  std::size_t from = 0;
  return between(document(), from, "```toml\n", "```");
}

// The name between single or double brackets; of the latter with one pair of them.
std::string table_name(const std::string& line) {
  const std::size_t open = line.find('[');
  return line.substr(open + 1, line.rfind(']') - open - 1);
}

// Headings "## [table]" and the first column of the rows below.
KeysOfTables documented_keys() {
  KeysOfTables keys;
  std::string table;
  std::istringstream lines(document());
  for (std::string line; std::getline(lines, line);) {
    std::size_t from = 0;
    if (line.rfind("## ", 0) == 0) table = line.find('[') < line.size() ? table_name(line) : "";
    if (line.rfind("| `", 0) == 0) {
      EXPECT_TRUE(keys[table].insert(between(line, from, "`", "`")).second) << line;
    }
  }
  return keys;
}

// The names that the reader lists when it meets one that it has never heard of.
std::set<std::string> names_offered(const std::string& table) {
  const std::string unheard_of = "quetzalcoatlus = 1\n";
  const std::string above = table == "[stage.hand]" ? "[[stage]]\n" : "";
  const std::string text =
      table.empty() ? unheard_of + smallest_scene()
      : smallest_scene().find("[" + table + "]\n") == std::string::npos
          ? smallest_scene() + above + "[" + table + "]\n" + unheard_of
          : replaced(smallest_scene(), "[" + table + "]\n", "[" + table + "]\n" + unheard_of);
  const std::string sentence = complaint(text);
  std::size_t from = sentence.find("it may hold");
  EXPECT_NE(from, std::string::npos) << sentence;
  std::set<std::string> names;
  for (std::string name; !(name = between(sentence, from, "'", "'")).empty();) names.insert(name);
  return names;
}

KeysOfTables read_keys() {
  const std::set<std::string> tables = {
      "curve",    "knot",     "ribbon",    "cloth",   "springs",      "air",  "gravity",
      "friction", "obstacle", "fastening", "[stage]", "[stage.hand]", "time", "recording"};
  KeysOfTables keys;
  for (const std::string& name : names_offered(""))
    if (tables.count(name) == 0 && name != "stage") keys[""].insert(name);
  for (const std::string& table : tables) keys[table] = names_offered(table);
  keys["[stage]"].erase("hand");
  return keys;
}

TEST(SceneDocument, documents_exactly_the_keys_that_are_read) {
  EXPECT_EQ(documented_keys(), read_keys());
}

TEST(SceneDocument, its_example_is_a_scene) {
  EXPECT_EQ(complaint(example()), "");
}

TEST(SceneDocument, its_example_has_every_key_but_the_other_ways_to_draw_and_to_pass_over) {
  KeysOfTables keys;
  std::string table;
  std::istringstream lines(example());
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind('[', 0) == 0)
      table = table_name(line);
    else if (!line.empty())
      keys[table].insert(line.substr(0, line.find(' ')));
  }
  keys["curve"].insert({"points", "crossings"});
  keys["ribbon"].insert({"outline", "outline_path"});
  keys["fastening"].insert("pull");  // not with stages
  keys["cloth"].insert("fabric");    // whose part the example plays itself
  EXPECT_EQ(keys, documented_keys());
}

}  // namespace ribbon::scene_document_test
