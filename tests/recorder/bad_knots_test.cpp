// Knots that cannot be tied as they are drawn or told, as a user meets them: a sentence with its
// place, and exit code 2, before anything is simulated.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "commandline/tool_run.h"

namespace ribbon::bad_knots_test {

class BadKnots : public ToolTest {
 protected:
  BadKnots() : ToolTest(RIBBON_RECORD) {}

  static std::string file_of(const std::string& scene) {
    return RIBBON_SAMPLES "/gallery/" + scene + ".toml";
  }
  void expect_refusal_with(const std::string& scene, const std::string& setting,
                           const std::string& words) const {
    expect_refusal(run(file_of(scene) + " -o knot.rbn --set '" + setting + "'"),
                   scene + ".toml" + words);
  }

  // A scene of the gallery with a setting, refused for what that says.
  void expect_refusal_of(const std::string& scene, const std::string& setting,
                         const std::string& sentence) const {
    expect_refusal_with(scene, setting, " with '" + setting + "': " + sentence);
  }
  // Likewise, for what the scene first says of this key.
  void expect_refusal_at(const std::string& scene, const std::string& setting,
                         const std::string& key, const std::string& sentence) const {
    expect_refusal_with(scene, setting,
                        ":" + place_of_value(file_of(scene), key) + ": " + sentence);
  }

  // Line and column.
  static std::string place_of_value(const std::string& file, const std::string& key) {
    const std::string text = read_file(file).value_or("");
    const std::string words = "\n" + key + " = ";
    const std::size_t at = text.find(words);
    EXPECT_NE(at, std::string::npos) << file << " tells no " << key;
    const auto lines_before = std::count(text.begin(), text.begin() + static_cast<long>(at), '\n');
    return std::to_string(lines_before + 2) + ":" + std::to_string(words.size());
  }

  // A drawing in pieces: two paths of a group.
  void expect_refusal_of_gaps(const std::string& one, const std::string& other,
                              const std::string& sentence) const {
    ASSERT_TRUE(write_file(folder_ / "knot.svg",
                           "<svg xmlns='http://www.w3.org/2000/svg'><g id='band'><path d='" + one +
                               "'/><path d='" + other + "'/></g></svg>"));
    expect_refusal_of_text("[curve]\nsvg = 'knot.svg'\npath = 'band'\n", "", sentence);
  }

  // A band, what is drawn of it, and its stages.
  void expect_refusal_of_text(const std::string& curve, const std::string& stages,
                              const std::string& sentence) const {
    ASSERT_TRUE(
        write_file(folder_ / "knot.toml", curve +
                                              "[ribbon]\nwidth = 0.005\nalong = 100\nacross = 4\n"
                                              "[air]\nresistance = 10\n[fastening]\nspeed = 0.3\n"
                                              "[time]\nduration = 9\n" +
                                              stages));
    expect_refusal(run("knot.toml -o knot.rbn"), sentence);
  }

  // A straight band in one stage.
  void expect_refusal_of_stage(const std::string& stage, const std::string& sentence) const {
    expect_refusal_of_text("[curve]\npoints = [[0, 0], [100, 0]]\n", "[[stage]]\n" + stage,
                           sentence);
  }
};

TEST_F(BadKnots, a_list_that_does_not_fit_its_drawing) {
  expect_refusal_of("reef", "curve.crossings=OUOOUOUOUUO",
                    "the drawing has 12 passages, 'crossings' has 11 letters; passage 12 "
                    "is at (60, 530)");
  expect_refusal_of("reef", "curve.crossings=OOOOUOUOUUOU",
                    "passages 2 and 11 meet at (0, 530) of the drawing, and both say O");
  expect_refusal_of("reef", "curve.crossings=OXOOUOUOUUOU", "letter 2 of 'crossings' is 'X'");
}

TEST_F(BadKnots, gaps_that_do_not_tell_what_passes_over) {
  expect_refusal_of_gaps("M -100 0 H -10", "M 10 0 H 100 V 90 H 50 V -90",
                         "drawing at (0, 0): this gap passes under nothing");
  expect_refusal_of_gaps("M -100 -4 H 100 L 120 0 L 100 4 H -100 L -120 -50 L -100 -100 H 0 V -10",
                         "M 0 10 V 100", "drawing at (0, 0): this gap passes under 2 strands");
  expect_refusal_of_gaps("M -100 0 H 100 V -100 H 0 V -10", "M 0 10 V 100 H -50 V -50",
                         "drawing at (-50, 0): two strands cross here, and neither has a gap");
}

TEST_F(BadKnots, hands_that_have_nothing_or_the_same) {
  expect_refusal_of("bow", "stage[1].hand[1].at=\"arm-lfet\"",
                    "the drawing has no mark 'arm-lfet'; it has 'arm-left'");
  expect_refusal_of_stage("name = 'knot'\n", "knot.toml:13:1: 'knot' has no hands");
  expect_refusal_of_stage("[[stage.hand]]\nat = [0, 0.1]\npull = [1, 0, 0]\nhold = true\n",
                          "knot.toml:17:8: a hand cannot both pull and hold");
  expect_refusal_of_stage(
      "[[stage.hand]]\nat = [0, 0.1]\npull = [1, 0, 0]\n"
      "[[stage.hand]]\nat = [0.05, 0.2]\nhold = true\n",
      "knot.toml:18:6: two hands of 'stage 1' fight over one part of the band");
}

TEST_F(BadKnots, a_stage_that_can_never_end) {
  expect_refusal_of_stage("[[stage.hand]]\nat = [0, 0.1]\nhold = true\n",
                          "knot.toml:13:1: 'stage 1' can never reach its goal");
}

TEST_F(BadKnots, a_knot_that_the_drawing_does_not_tie) {
  expect_refusal_of("reef", "knot.expect=granny knot",
                    "the drawing ties: reef knot (6 crossings); expected is: granny knot");
}

TEST_F(BadKnots, widths_that_no_mesh_can_hold) {
  expect_refusal_of("tapered", "ribbon.width=[[0, 0.0005], [1, 0.13]]",
                    "where the ribbon is 0.0005 m wide its particles are");
  expect_refusal_of("tapered", "ribbon.width=[[0, 0.05], [0.5, 0.05], [0.51, 3], [1, 3]]",
                    "at 0.5 of its length the ribbon becomes wider or narrower by");
}

TEST_F(BadKnots, a_ribbon_that_begins_inside_the_object) {
  expect_refusal_at("reef", "obstacle.scale=40", "mesh", "the ribbon lies inside the obstacle");
}

}  // namespace ribbon::bad_knots_test
