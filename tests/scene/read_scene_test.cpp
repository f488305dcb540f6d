#include <gtest/gtest.h>

#include <ostream>

#include "result/refusal.h"
#include "scene/scene.h"
#include "scene/scene_files.h"

namespace ribbon::read_scene_test {

std::string with(const std::string& lines) {
  return smallest_scene() + lines;
}

std::string with_in(const std::string& table, const std::string& lines) {
  return replaced(smallest_scene(), table + "\n", table + "\n" + lines + "\n");
}

// Names of files may be any bytes; those of recordings are text.
TEST(ReadScene, one_without_a_name_is_named_after_its_file_in_utf8) {
  EXPECT_EQ(read_scene("a/kn\xF6t.toml", smallest_scene())->name, "kn\uFFFDt");
  EXPECT_EQ(read_scene("a/kn\u00F6t.toml", smallest_scene())->name, "kn\u00F6t");
}

TEST(ReadScene, what_a_scene_does_not_name_costs_nothing) {
  const Scene scene = read_text(smallest_scene()).value();
  EXPECT_EQ(scene.name, "knot");
  EXPECT_EQ(scene.text, smallest_scene());
  EXPECT_FALSE(scene.obstacle.has_value());
  EXPECT_FALSE(scene.fastening.has_value());
  EXPECT_EQ(scene.springs.stretch, 0);
  EXPECT_EQ(scene.springs.shear, 0);
  EXPECT_EQ(scene.springs.bend, 0);
  EXPECT_EQ(scene.air_resistance_per_s, 0);
  EXPECT_FALSE(scene.gravity_m_s2.has_value());
  EXPECT_EQ(scene.friction, 0);
  EXPECT_EQ(scene.ribbon.thickness_m, 0);
}

TEST(ReadScene, defaults_are_as_documented) {
  const Scene scene = read_text(smallest_scene()).value();
  EXPECT_EQ(scene.curve.unit_m, 0.001);
  EXPECT_EQ(scene.curve.origin, Eigen::Vector2d(0, 0));
  EXPECT_EQ(scene.curve.axis, Axis::y);
  EXPECT_TRUE(scene.curve.first_passage_over);
  EXPECT_DOUBLE_EQ(scene.curve.clearance_m, 0.005);
  EXPECT_EQ(scene.ribbon.mass_kg, 1);
  EXPECT_EQ(scene.contact, ContactMethod::gate);
  EXPECT_EQ(scene.time.step_s, 0.01);
  EXPECT_EQ(scene.time.until, RunsUntil::duration);
  EXPECT_EQ(scene.time.integrator, std::nullopt);
  EXPECT_EQ(scene.recording.frames_per_second, 50);
  EXPECT_EQ(scene.recording.max_position_error, std::nullopt);
  EXPECT_EQ(scene.recording.checkpoint_every_s, 200);
}

TEST(ReadScene, every_key_reaches_its_place) {
  const std::string text =
      "name = 'my knot'\n"
      "contact = 'paper'\n"
      "[curve]\nsvg = '/drawings/a.svg'\npath = 'p'\nunit = 2\norigin = [3, 4.5]\naxis = 'z'\n"
      "first = 'under'\nclearance = 5\n"
      "[ribbon]\nwidth = 6\nalong = 7\nacross = 8\nmass = 9\nthickness = 0.125\n"
      "[springs]\nstretch = 10\nshear = 11\nbend = 12\n"
      "[air]\nresistance = 13\n"
      "[gravity]\nacceleration = [1, 2, 3.5]\n"
      "[friction]\ncoefficient = 0.375\n"
      "[obstacle]\nmesh = '/meshes/b.obj'\nscale = 14\nposition = [15, 16, 17]\n"
      "[fastening]\nspeed = 18\npull = 'ends'\nmax_speed = 18.5\nyield = 0.25\naxis_point = [19, "
      "20, 21]\naxis = [0, 3, 4]\n"
      "[time]\nstep = 0.5\nduration = 22\nuntil = 'tight'\nintegrator = 'implicit'\n"
      "[recording]\nframes_per_second = 0.25\nmax_position_error = 1e-4\n"
      "checkpoint_every = 0.5\n";
  const Scene scene = read_text(text).value();
  EXPECT_EQ(scene.name, "my knot");
  EXPECT_EQ(scene.contact, ContactMethod::paper);
  EXPECT_EQ(std::get<DrawnSvg>(scene.curve.drawing).file.path, "/drawings/a.svg");
  EXPECT_EQ(std::get<DrawnSvg>(scene.curve.drawing).path_id, "p");
  EXPECT_EQ(scene.curve.unit_m, 2);
  EXPECT_EQ(scene.curve.origin, Eigen::Vector2d(3, 4.5));
  EXPECT_EQ(scene.curve.axis, Axis::z);
  EXPECT_FALSE(scene.curve.first_passage_over);
  EXPECT_EQ(scene.curve.clearance_m, 5);
  EXPECT_EQ(scene.ribbon.width_m, 6);
  EXPECT_EQ(scene.ribbon.along, 7);
  EXPECT_EQ(scene.ribbon.across, 8);
  EXPECT_EQ(scene.ribbon.mass_kg, 9);
  EXPECT_EQ(scene.ribbon.thickness_m, 0.125);
  EXPECT_EQ(scene.gravity_m_s2, Eigen::Vector3d(1, 2, 3.5));
  EXPECT_EQ(scene.friction, 0.375);
  EXPECT_EQ(scene.springs.stretch, 10);
  EXPECT_EQ(scene.springs.shear, 11);
  EXPECT_EQ(scene.springs.bend, 12);
  EXPECT_EQ(scene.air_resistance_per_s, 13);
  EXPECT_EQ(scene.obstacle->file.path, "/meshes/b.obj");
  EXPECT_EQ(scene.obstacle->scale, 14);
  EXPECT_EQ(scene.obstacle->position_m, Eigen::Vector3d(15, 16, 17));
  EXPECT_EQ(scene.fastening->speed_m_s, 18);
  EXPECT_EQ(scene.fastening->pull, FasteningPull::ends);
  EXPECT_EQ(scene.fastening->max_speed_m_s, 18.5);
  EXPECT_EQ(scene.fastening->yield_strain, 0.25);
  EXPECT_EQ(scene.fastening->axis_point_m, Eigen::Vector3d(19, 20, 21));
  EXPECT_TRUE(scene.fastening->axis_direction.isApprox(Eigen::Vector3d(0, 0.6, 0.8), 1e-15));
  EXPECT_EQ(scene.time.step_s, 0.5);
  EXPECT_EQ(scene.time.duration_s, 22);
  EXPECT_EQ(scene.time.until, RunsUntil::tight);
  EXPECT_EQ(scene.time.integrator, IntegrationMethod::implicit);
  EXPECT_EQ(scene.recording.frames_per_second, 0.25);
  EXPECT_EQ(scene.recording.max_position_error, 1e-4);
  EXPECT_EQ(scene.recording.checkpoint_every_s, 0.5);
}

TEST(ReadScene, crossings_are_letters_without_their_blanks) {
  const auto scene = [](const std::string& letters) {
    return replaced(smallest_scene(), "[curve]\n", "[curve]\ncrossings = '" + letters + "'\n");
  };
  EXPECT_FALSE(read_text(smallest_scene()).value().curve.crossings.has_value());
  const auto list = read_text(scene("OUO UOU")).value().curve.crossings;
  ASSERT_TRUE(list.has_value());
  EXPECT_EQ(list->letters, "OUOUOU");
  EXPECT_THAT(list->place, EndsWith("knot.toml:2:13"));
  EXPECT_THAT(complaint(scene("OUO XOU")),
              StartsWith("knot.toml:2:13: letter 4 of 'crossings' is 'X'"));
  EXPECT_THAT(complaint(replaced(scene("OU"), "[curve]\n", "[curve]\nfirst = 'over'\n")),
              StartsWith("knot.toml:2:9: [curve] has both 'first' and 'crossings'"));
}

TEST(ReadScene, the_knot_of_a_part_is_expected_between_shares_or_marks) {
  const auto knot = [](const std::string& lines) {
    return read_text(with("[knot]\nexpect = 'bow'\n" + lines)).map([](const Scene& scene) {
      return *scene.knot;
    });
  };
  EXPECT_FALSE(knot("")->between.has_value());
  const KnotScene found = knot("between = ['tip', 0.75]\nexpect_between = 'reef knot'\n").value();
  EXPECT_EQ(found.between, (BandPart{{Mark{"tip"}, 0.75}}));
  EXPECT_EQ(found.expect_between->name, "reef knot");
  EXPECT_TRUE(knot("between = [1, 0]\n").has_value()) << "what it is need not be expected";
  EXPECT_THAT(refusal_of(knot("expect_between = 'reef knot'\n")),
              HasSubstr("'expect_between' is the knot of a part of the band, but no part is told"));
  for (const char* wrong : {"0.5", "[0.5]", "[0.2, 0.5, 0.7]", "[0.5, 1.5]", "[0.5, '']"})
    EXPECT_THAT(refusal_of(knot("between = " + std::string(wrong) + "\n")),
                HasSubstr("'between' must be two places of the band"))
        << wrong;
  EXPECT_THAT(refusal_of(knot("between = ['tip', 'tip']\n")),
              HasSubstr("must be two places that differ"));
}

TEST(ReadScene, a_direction_may_have_any_length) {
  const auto axis = [](const std::string& numbers) {
    return read_text(
               with("[air]\nresistance = 1\n[fastening]\nspeed = 1\naxis = " + numbers + "\n"))
        .value()
        .fastening->axis_direction;
  };
  const Eigen::Vector3d expected = axis("[0, 3, 4]");
  for (const char* numbers : {"[0, 3e11, 4e11]", "[0, 3e-300, 4e-300]", "[0, 3e-320, 4e-320]"})
    EXPECT_TRUE(axis(numbers).isApprox(expected, 1e-3)) << numbers;
  EXPECT_NEAR(axis("[0, 3e-320, 4e-320]").norm(), 1, 1e-15) << "whatever digits it has";
}

TEST(ReadScene, hands_yield_unless_told_never_to) {
  const auto yield = [](const std::string& line) {
    return read_text(with("[air]\nresistance = 1\n[fastening]\nspeed = 1\n" + line))
        .map([](const Scene& scene) { return scene.fastening->yield_strain; });
  };
  EXPECT_EQ(yield("").value(), 0.05);
  EXPECT_EQ(yield("yield = 0.25\n").value(), 0.25);
  EXPECT_EQ(yield("yield = 'never'\n").value(), unyielding);
  for (const char* wrong : {"'seldom'", "0", "1.5", "inf", "true"})
    EXPECT_THAT(refusal_of(yield("yield = " + std::string(wrong) + "\n")),
                HasSubstr("must be a number from 0.001 to 1, or \"never\""))
        << wrong;
}

TEST(ReadScene, a_number_for_gravity_points_down) {
  const Scene scene = read_text(with("[gravity]\nacceleration = 9.81\n")).value();
  EXPECT_EQ(scene.gravity_m_s2, Eigen::Vector3d(0, -9.81, 0));
}

TEST(ReadScene, gravity_of_zero_is_none) {
  for (const char* zero : {"0", "0.0", "[0, 0, -0.0]"})
    EXPECT_FALSE(read_text(with("[gravity]\nacceleration = " + std::string(zero) + "\n"))
                     .value()
                     .gravity_m_s2.has_value())
        << zero;
}

TEST(ReadScene, points_are_read_in_order) {
  const Scene scene = read_text(smallest_scene()).value();
  const std::vector<Eigen::Vector2d> expected = {{0, 0}, {100, 50}};
  EXPECT_EQ(std::get<DrawnPoints>(scene.curve.drawing).points, expected);
}

TEST(ReadScene, relative_file_names_are_taken_from_the_scenes_folder) {
  const Scene scene = read_text(with("[obstacle]\nmesh = '../meshes/a.obj'\n")).value();
  EXPECT_TRUE(scene.obstacle->file.path.is_absolute());
  EXPECT_EQ(scene.obstacle->file.path.filename(), "a.obj");
  EXPECT_EQ(scene.obstacle->file.path.parent_path().filename(), "meshes");
  EXPECT_THAT(scene.obstacle->file.place, EndsWith("knot.toml:11:8"));
}

TEST(ReadScene, a_missing_file_is_named) {
  EXPECT_THAT(refusal_of(read_scene("/no/such/knot.toml")), StartsWith("/no/such/knot.toml: "));
}

TEST(ReadScene, a_syntax_error_has_line_and_column) {
  const std::string sentence = complaint("[curve]\npoints = [[0, 0]\n[ribbon]\n");
  EXPECT_THAT(sentence, StartsWith("knot.toml:3:"));
  EXPECT_THAT(sentence, HasSubstr("; correct the TOML here"));
}

TEST(ReadScene, a_key_given_twice_is_an_error) {
  EXPECT_THAT(complaint(with_in("[ribbon]", "width = 1")), StartsWith("knot.toml:5:"));
}

TEST(ReadScene, a_mistyped_key_is_told_with_the_right_one) {
  EXPECT_EQ(complaint(replaced(smallest_scene(), "width", "widht")),
            "knot.toml:4:1: unknown key 'widht' in [ribbon]; did you mean 'width'?");
}

TEST(ReadScene, a_mistyped_table_is_told_with_the_right_one) {
  EXPECT_EQ(complaint(with("[spring]\nbend = 1\n")),
            "knot.toml:10:2: unknown table 'spring' in the lines above all tables; "
            "did you mean 'springs'?");
}

TEST(ReadScene, a_key_of_another_table_is_sent_there) {
  EXPECT_EQ(complaint(with("resistance = 5\n")),
            "knot.toml:10:1: unknown key 'resistance' in [time]; it belongs in [air]");
  EXPECT_EQ(complaint(with("name = 'late'\n")),
            "knot.toml:10:1: unknown key 'name' in [time]; it belongs in the lines above all "
            "tables");
}

TEST(ReadScene, an_unheard_of_key_is_answered_with_the_known_ones) {
  EXPECT_EQ(
      complaint(with_in("[ribbon]", "colour = 'red'")),
      "knot.toml:4:1: unknown key 'colour' in [ribbon]; "
      "it may hold 'width', 'outline', 'outline_path', 'along', 'across', 'mass', 'thickness'");
}

TEST(ReadScene, a_key_with_control_characters_stays_on_one_line) {
  EXPECT_THAT(complaint(with_in("[ribbon]", "\"a\\nb\\u001b\" = 1")), HasSubstr("'a?b?'"));
}

TEST(ReadScene, a_missing_key_is_told_at_its_table) {
  EXPECT_EQ(complaint(replaced(smallest_scene(), "width = 0.05", "")),
            "knot.toml:3:1: 'width' is missing in [ribbon]; add for example 'width = 0.05'");
  EXPECT_EQ(complaint(with("[obstacle]\n")),
            "knot.toml:10:1: 'mesh' is missing in [obstacle]; "
            "add for example 'mesh = \"hourglass.obj\"'");
}

TEST(ReadScene, a_missing_table_is_told_with_what_it_needs) {
  EXPECT_EQ(complaint(""), "knot.toml: [curve] is missing; add '[curve]'");
  EXPECT_EQ(complaint(replaced(smallest_scene(), "[time]\nduration = 4\n", "")),
            "knot.toml: [time] is missing; "
            "add '[time]' with for example 'duration = 4' on the lines below");
}

TEST(ReadScene, a_value_in_place_of_a_table_is_an_error) {
  EXPECT_EQ(complaint("air = 5\n" + smallest_scene()),
            "knot.toml:1:7: 'air' must be a table, not 5; "
            "write '[air]' and its keys on the lines below");
}

struct Impossible {
  std::string name;
  std::string text;
  std::string sentence;

  friend std::ostream& operator<<(std::ostream& stream, const Impossible& impossible) {
    return stream << impossible.name;
  }
};

std::string ribbon_line(const std::string& from, const std::string& to) {
  return replaced(smallest_scene(), from, to);
}

TEST(ReadScene, a_width_may_vary_along_the_ribbon) {
  const Scene scene = read_text(ribbon_line("0.05", "[[0, 0.02], [0.5, 0.04], [1, 0.06]]")).value();
  ASSERT_TRUE(scene.ribbon.profile.has_value());
  EXPECT_EQ(scene.ribbon.profile->points,
            (std::vector<WidthAt>{{0, 0.02}, {0.5, 0.04}, {1, 0.06}}));
  EXPECT_THAT(scene.ribbon.profile->place, testing::EndsWith("knot.toml:4:9"));
  EXPECT_NEAR(scene.ribbon.width_m, 0.04, 1e-9) << "the mean of its rows";
  EXPECT_NEAR(scene.curve.clearance_m, 0.004, 1e-9) << "a tenth of it";
}

TEST(ReadScene, a_profile_of_one_width_is_that_width) {
  const Scene alike = read_text(ribbon_line("0.05", "[[0, 0.07], [0.5, 0.07], [1, 0.07]]")).value();
  const Scene number = read_text(ribbon_line("0.05", "0.07")).value();
  EXPECT_EQ(alike.ribbon, number.ribbon);
  EXPECT_EQ(alike.curve, number.curve);
}

class ImpossibleValue : public testing::TestWithParam<Impossible> {};

TEST_P(ImpossibleValue, is_told_with_place_and_remedy) {
  EXPECT_EQ(complaint(GetParam().text), "knot.toml:" + GetParam().sentence);
}

const std::string width_rule = "'width' must be a number above 0 (from 1e-12 to 1e12), not ";
const std::string shares_rule =
    "'width' must be pairs whose shares of the length rise from 0 to 1, not ";
const std::string width_remedy = "; write for example 'width = 0.05'";

INSTANTIATE_TEST_SUITE_P(
    ReadScene, ImpossibleValue,
    testing::Values(
        Impossible{"zero", ribbon_line("0.05", "0"), "4:9: " + width_rule + "0" + width_remedy},
        Impossible{"negative", ribbon_line("0.05", "-0.5"),
                   "4:9: " + width_rule + "-0.5" + width_remedy},
        Impossible{"not_a_number", ribbon_line("0.05", "nan"),
                   "4:9: " + width_rule + "nan" + width_remedy},
        Impossible{"infinite", ribbon_line("0.05", "inf"),
                   "4:9: " + width_rule + "inf" + width_remedy},
        Impossible{"huge", ribbon_line("0.05", "1e300"),
                   "4:9: " + width_rule + "1e+300" + width_remedy},
        Impossible{"text_for_a_number", ribbon_line("0.05", "'5 cm'"),
                   "4:9: " + width_rule + "the text '5 cm'" + width_remedy},
        Impossible{"one_pair_for_a_profile", ribbon_line("0.05", "[[0, 0.05]]"),
                   "4:9: 'width' must be a number, or at least 2 pairs [share of the length, "
                   "width], not an array of 1" +
                       width_remedy},
        Impossible{"no_pair_in_a_profile", ribbon_line("0.05", "[[0, 0.05], [1]]"),
                   "4:21: 'width' must be pairs of a share of the length and a width, not [1]" +
                       width_remedy},
        Impossible{"profile_that_begins_late", ribbon_line("0.05", "[[0.1, 0.05], [1, 0.1]]"),
                   "4:11: " + shares_rule + "0.1" + width_remedy},
        Impossible{"profile_that_ends_early", ribbon_line("0.05", "[[0, 0.05], [0.9, 0.1]]"),
                   "4:22: " + shares_rule + "0.9" + width_remedy},
        Impossible{"profile_that_stands_still",
                   ribbon_line("0.05", "[[0, 1], [0.5, 1], [0.5, 2], [1, 1]]"),
                   "4:29: " + shares_rule + "0.5" + width_remedy},
        Impossible{"profile_that_goes_back",
                   ribbon_line("0.05", "[[0, 1], [0.5, 1], [0.4, 2], [1, 1]]"),
                   "4:29: " + shares_rule + "0.4" + width_remedy},
        Impossible{"profile_beyond_the_end", ribbon_line("0.05", "[[0, 1], [1.5, 1], [1, 1]]"),
                   "4:19: " + shares_rule + "1.5" + width_remedy},
        Impossible{"profile_with_two_ends",
                   ribbon_line("0.05", "[[0, 0.05], [1, 0.05], [1, 0.03]]"),
                   "4:33: " + shares_rule + "1" + width_remedy},
        Impossible{"profile_of_no_width", ribbon_line("0.05", "[[0, 0.05], [1, 0]]"),
                   "4:25: 'width' must be pairs with a width above 0 (from 1e-12 to 1e12), not 0" +
                       width_remedy},
        Impossible{"profile_of_negative_width", ribbon_line("0.05", "[[0, -0.05], [1, 1]]"),
                   "4:14: 'width' must be pairs with a width above 0 (from 1e-12 to 1e12), not "
                   "-0.05" +
                       width_remedy},
        Impossible{"fraction_for_a_count", ribbon_line("400", "1.5"),
                   "5:9: 'along' must be a whole number of at least 2, not 1.5; "
                   "write for example 'along = 400'"},
        Impossible{"real_number_for_a_count", ribbon_line("400", "4e2"),
                   "5:9: 'along' must be a whole number of at least 2, not 400.0; "
                   "write for example 'along = 400'"},
        Impossible{"one_particle", ribbon_line("across = 8", "across = 1"),
                   "6:10: 'across' must be a whole number of at least 2, not 1; "
                   "write for example 'across = 8'"},
        Impossible{"count_beyond_32_bits", ribbon_line("400", "4294967296"),
                   "5:9: 'along' must be at most 16777216, not 4294967296; "
                   "write for example 'along = 400'"},
        Impossible{"too_many_particles_together", ribbon_line("400", "2097153"),
                   "5:9: 'along' times 'across' is 16777224 particles; "
                   "write smaller numbers, at most 16777216 particles together"},
        Impossible{"more_columns_than_a_recording_holds", ribbon_line("= 8", "= 1048577"),
                   "6:10: 'across' is more than a recording holds; write at most 1048576"},
        Impossible{"thicker_than_wide", ribbon_line("across = 8", "across = 8\nthickness = 1"),
                   "7:13: 'thickness' is 1 m, more than the 'width' of the ribbon; write the "
                   "thickness of the cloth in metres, for example 'thickness = 0.001'"},
        Impossible{"negative_spring", with("[springs]\nbend = -1\n"),
                   "11:8: 'bend' must be a number from 0 to 1e12, not -1; "
                   "write for example 'bend = 10'"},
        Impossible{"unknown_word", with_in("[curve]", "axis = 'w'"),
                   "2:8: 'axis' must be one of \"x\", \"y\", \"z\", not the text 'w'; "
                   "write for example 'axis = \"y\"'"},
        Impossible{"unknown_accuracy", "accuracy = 'best'\n" + smallest_scene(),
                   "1:12: 'accuracy' must be one of \"draft\", \"balanced\", \"fine\", "
                   "\"reference\", not the text 'best'; write for example 'accuracy = "
                   "\"balanced\"'"},
        Impossible{"two_coordinates_for_three", with("[obstacle]\nmesh = 'a'\nposition = [1, 2]\n"),
                   "12:12: 'position' must be 3 numbers from -1e12 to 1e12 in brackets, "
                   "not [1, 2]; write for example 'position = [0, 0, 0]'"},
        Impossible{"text_among_coordinates", with_in("[curve]", "origin = [0, 'a']"),
                   "2:14: 'origin' must be 2 numbers from -1e12 to 1e12 in brackets, "
                   "not the text 'a'; write for example 'origin = [0, 0]'"},
        Impossible{"gravity_that_may_be_meant_upwards", with("[gravity]\nacceleration = -9.81\n"),
                   "11:16: 'acceleration' must be a number from 0 to 1e12, down along -y, or 3 "
                   "numbers, not -9.81; write for example 'acceleration = [0, -9.81, 0]'"},
        Impossible{"gravity_of_two_coordinates", with("[gravity]\nacceleration = [0, -9.81]\n"),
                   "11:16: 'acceleration' must be 3 numbers from -1e12 to 1e12 in brackets, not "
                   "[0, -9.81]; write for example 'acceleration = [0, -9.81, 0]'"},
        Impossible{"gravity_of_nothing", with("[gravity]\n"),
                   "10:1: 'acceleration' is missing in [gravity]; add for example "
                   "'acceleration = [0, -9.81, 0]'"},
        Impossible{"infinite_point", ribbon_line("[100, 50]", "[100, inf]"),
                   "2:25: 'points' must be 2 numbers from -1e12 to 1e12 in brackets, not inf; "
                   "write for example 'points = [[0, 0], [100, 50]]'"},
        Impossible{"one_point", ribbon_line(", [100, 50]", ""),
                   "2:10: 'points' must be at least 2 points, each [x, y], not an array of 1; "
                   "write for example 'points = [[0, 0], [100, 50]]'"},
        Impossible{"empty_text", "name = ''\n" + smallest_scene(),
                   "1:8: 'name' must be a text of one line that is not empty, not the text ''; "
                   "write for example 'name = \"overhand-hourglass\"'"},
        Impossible{"axis_without_direction",
                   with("[air]\nresistance = 1\n[fastening]\nspeed = 1\naxis = [0, 0, 0]\n"),
                   "14:8: 'axis' must be a direction that is not all zeros, not [0, 0, 0]; "
                   "write for example 'axis = [0, 1, 0]'"},
        Impossible{"too_coarse_recording", with("[recording]\nmax_position_error = 0.5\n"),
                   "11:22: 'max_position_error' must be a number from 1e-7 to 0.01, or 0, not 0.5; "
                   "write for example 'max_position_error = 1e-5'"},
        Impossible{"too_many_steps", ribbon_line("duration = 4", "duration = 1e8"),
                   "8:12: 'duration' is 10000000000 steps of 0.01 s; "
                   "write a shorter duration, a longer step or fewer frames per second, at most "
                   "1e9 steps"},
        Impossible{"less_than_a_step", ribbon_line("duration = 4", "duration = 0.005"),
                   "8:12: 'duration' is shorter than one 'step' of 0.01 s; "
                   "write a longer duration or a shorter step"},
        Impossible{"no_drawing", ribbon_line("points = [[0, 0], [100, 50]]", ""),
                   "1:1: [curve] has no drawing; write for example 'svg = \"overhand.svg\"' "
                   "or 'points = [[0, 0], [100, 50]]'"},
        Impossible{"two_drawings", with_in("[curve]", "svg = 'a.svg'"),
                   "3:10: [curve] has both 'svg' and 'points'; remove one of them"},
        Impossible{"width_and_outline", ribbon_line("0.05", "0.05\noutline = 'tie.svg'"),
                   "5:11: [ribbon] has both 'width' and 'outline'; remove one of them"},
        Impossible{"outline_path_alone", ribbon_line("0.05", "0.05\noutline_path = 'tie'"),
                   "5:16: 'outline_path' names a path of an SVG file, but there is no 'outline'; "
                   "add for example 'outline = \"tie.svg\"', or remove 'outline_path'"},
        Impossible{"path_of_points", with_in("[curve]", "path = 'a'"),
                   "2:8: 'path' names a path of an SVG file, but the drawing is a list of "
                   "'points'; remove 'path', or replace 'points' by 'svg'"},
        Impossible{"tight_without_fastening", with_in("[time]", "until = 'tight'"),
                   "8:9: a ribbon that nothing pulls never becomes 'tight'; add '[fastening]' with "
                   "for example 'speed = 0.5' below it, or remove 'until'"},
        Impossible{"fastening_without_air", with("[fastening]\nspeed = 1\n"),
                   "10:1: [fastening] needs air resistance, because its force is the one that "
                   "reaches 'speed' against it; write for example 'resistance = 10' in [air]"}),
    [](const auto& instance) { return instance.param.name; });

// By hand; those of 50 frames a second are as long as they were asked for, to the bit.
TEST(ReadScene, steps_are_shortened_until_each_frame_falls_on_one) {
  struct Rate {
    const char* frames_per_second;
    const char* step;
    double expected_s;
  };
  for (const Rate& rate :
       {Rate{"50", "0.01", 0.01}, Rate{"20", "0.01", 0.01}, Rate{"100", "0.01", 0.01},
        Rate{"24", "0.01", 1.0 / 120}, Rate{"60", "0.01", 1.0 / 120}, Rate{"30", "0.01", 1.0 / 120},
        Rate{"29.97", "0.01", 1 / 29.97 / 4}, Rate{"101", "0.01", 1.0 / 101},
        Rate{"1000", "0.01", 0.001}, Rate{"24", "0.00125", 1.0 / 24 / 34},
        Rate{"0.001", "0.01", 0.01}, Rate{"3333.3333333333335", "0.0003", 0.0003}}) {
    const std::string text =
        with("[recording]\nframes_per_second = " + std::string(rate.frames_per_second) + "\n");
    const auto scene =
        read_text(replaced(text, "duration", "step = " + std::string(rate.step) + "\nduration"));
    EXPECT_DOUBLE_EQ(scene.value().time.step_s, rate.expected_s) << rate.frames_per_second;
    EXPECT_LE(scene.value().time.step_s, std::stod(rate.step)) << rate.frames_per_second;
  }
}

TEST(ReadScene, long_steps_lower_the_default_frame_rate) {
  const auto scene = read_text(replaced(smallest_scene(), "duration", "step = 0.25\nduration"));
  EXPECT_EQ(scene.value().recording.frames_per_second, 4);
}

TEST(ReadScene, the_most_particles_are_accepted) {
  const Scene scene = read_text(replaced(smallest_scene(), "400", "2097152")).value();
  EXPECT_EQ(scene.ribbon.along, 2097152);
}

TEST(ReadScene, inline_tables_and_dotted_keys_are_tables) {
  const Scene scene =
      read_text("air = { resistance = 5 }\nsprings.bend = 2\n" + smallest_scene()).value();
  EXPECT_EQ(scene.air_resistance_per_s, 5);
  EXPECT_EQ(scene.springs.bend, 2);
}

TEST(ReadScene, a_cut_off_scene_is_an_error_and_never_a_crash) {
  const std::string text = "name = 'a'\n" + smallest_scene();
  const std::size_t complete = text.find("4\n# the end") + 1;
  for (std::size_t size = 0; size < complete; ++size)
    EXPECT_NE(complaint(text.substr(0, size)), "") << text.substr(0, size);
  EXPECT_EQ(complaint(text.substr(0, complete)), "");
}

TEST(ReadScene, bytes_that_are_no_text_are_an_error) {
  EXPECT_THAT(complaint(std::string("\x80\xff\0", 3)), StartsWith("knot.toml:1:"));
}

}  // namespace ribbon::read_scene_test
