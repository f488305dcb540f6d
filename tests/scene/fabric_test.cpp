#include "scene/fabric.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>

#include "files/files.h"
#include "ribbon_mesh/fabric_springs.h"
#include "scene/scene.h"
#include "scene/scene_files.h"
#include "text/number_text.h"

namespace ribbon::fabric_test {

using testing::HasSubstr;

Scene scene_with(const std::string& lines) {
  return read_text(smallest_scene() + lines).value();
}

TEST(Fabric, tells_what_the_scene_leaves_open) {
  const Scene scene = scene_with("[cloth]\nfabric = \"cotton\"\n");
  ASSERT_TRUE(scene.cloth.has_value());
  EXPECT_EQ(scene.cloth->fabric.name, "cotton");
  EXPECT_TRUE(scene.cloth->tells_mass && scene.cloth->tells_thickness);
  EXPECT_TRUE(scene.cloth->tells_stretch && scene.cloth->tells_shear && scene.cloth->tells_bend);
  EXPECT_EQ(scene.ribbon.thickness_m, scene.cloth->fabric.thickness_m);
  EXPECT_EQ(scene.springs.damping, scene.cloth->fabric.damping);
  EXPECT_EQ(scene.friction, scene.cloth->fabric.friction);
  EXPECT_FALSE(scene.time.integrator.has_value());
}

TEST(Fabric, leaves_to_the_scene_what_that_says_itself) {
  const Scene scene = read_text(smallest_scene() +
                                "[cloth]\nfabric = \"cotton\"\n"
                                "[springs]\nshear = 3\ndamping = 0.25\n"
                                "[friction]\ncoefficient = 0.125\n")
                          .value();
  EXPECT_FALSE(scene.cloth->tells_shear);
  EXPECT_TRUE(scene.cloth->tells_stretch);
  EXPECT_EQ(scene.springs.shear, 3);
  EXPECT_EQ(scene.springs.damping, 0.25);
  EXPECT_EQ(scene.friction, 0.125);
}

TEST(Fabric, of_an_unknown_name_is_refused_with_the_place_and_the_names) {
  const std::string sentence = complaint(smallest_scene() + "[cloth]\nfabric = \"silkk\"\n");
  EXPECT_THAT(sentence, HasSubstr("knot.toml:"));
  for (const Fabric& fabric : fabrics)
    EXPECT_THAT(sentence, HasSubstr('"' + std::string(fabric.name) + '"'));
  EXPECT_THAT(complaint(smallest_scene() + "[cloth]\n"), HasSubstr("'fabric' is missing"));
}

TEST(Fabric, that_has_nothing_to_tell_is_refused) {
  const std::string text =
      replaced(smallest_scene(), "[ribbon]\n", "[ribbon]\nmass = 1\nthickness = 0.001\n") +
      "[cloth]\nfabric = \"silk\"\n[springs]\nstretch = 1\nshear = 1\nbend = 1\ndamping = 1\n";
  EXPECT_EQ(complaint(text), "");
  EXPECT_THAT(complaint(text + "[friction]\ncoefficient = 1\n"),
              HasSubstr("says all that 'silk' would tell"));
}

TEST(Fabric, is_set_like_any_other_setting) {
  EXPECT_EQ(read_scene("knot.toml", smallest_scene(), {"cloth.fabric=obi brocade"})
                .value()
                .cloth->fabric.name,
            "obi brocade");
}

// Of a row of the document: "| `silk` | 0.0607 [1] | ...", without the marks of sources.
std::string documented(const std::string& name) {
  const std::string document = read_file(RIBBON_FABRICS_DOCUMENT).value();
  const std::string first = "| `" + name + "`";
  const std::size_t begin = document.find(first);
  EXPECT_NE(begin, std::string::npos) << name;
  const std::string row = document.substr(begin, document.find('\n', begin) - begin);
  return std::regex_replace(row, std::regex(R"( \[[e0-9]\])"), "");
}

TEST(Fabric, has_the_numbers_of_the_document) {
  for (const Fabric& fabric : fabrics) {
    std::string row = "| `" + std::string(fabric.name) + "`";
    for (const double number :
         {fabric.mass_kg_m2, 1e3 * fabric.thickness_m, fabric.stretch_n_m,
          std::round(std::min(fabric.stretch_n_m, most_stretch_of_mass_m2_s2 * fabric.mass_kg_m2)),
          fabric.shear_n_m, 1e6 * fabric.bending_nm, fabric.damping, fabric.friction})
      row += " | " + short_number(number);
    EXPECT_EQ(documented(std::string(fabric.name)), row + " |");
  }
}

}  // namespace ribbon::fabric_test
