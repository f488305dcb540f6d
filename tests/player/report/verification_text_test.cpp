#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "player/report/verification_report.h"
#include "result/refusal.h"

namespace ribbon::verification_text_test {

// 3 x 3 particles, 8 triangles.
Verification all_in_order() {
  Verification verification;
  verification.header.grid = {3, 3};
  verification.header.stated_gap_m = 0.25;
  verification.header.limited_edges = {.along = true, .across = true, .diagonals = true};
  verification.header.strain_limit = 0.1;
  verification.frames_asked = 12;
  verification.frames_checked = 12;
  verification.smallest_gap = {{0.5, {7, 10}}, 4};
  verification.largest_strain = {{0.0625, 4, 7}, 9};
  verification.knot.certificate = "trefoil";
  verification.knot.certified_frames = 3;
  return verification;
}

Verification all_wrong() {
  Verification verification = all_in_order();
  verification.frames_checked = 9;
  verification.lost = {3, 4, 5};
  verification.not_finite = {7};
  verification.damaged = true;
  verification.intersecting_pairs = 6;
  verification.all_pairs_counted = false;
  verification.intersecting_frames = 1;
  verification.most_intersections = {6, 8};
  verification.first_intersections = {{8, 0.125, {0, 6}}, {9, std::nullopt, {0, 9}}};
  verification.smallest_gap = {{0, {0, 6}}, 8};
  verification.largest_strain = {{0.65, 4, 8}, 9};
  verification.knot.changes = {{1, 10, "trefoil", "unknot", 0.125}};
  return verification;
}

TEST(VerificationText, what_is_in_order_reads_so) {
  EXPECT_EQ(
      verification_text("knot.rbn", all_in_order()),
      "recording       knot.rbn\n"
      "frames          12 of 12 checked\n"
      "intersections   none\n"
      "smallest gap    0.5 m in frame 4, ribbon row 1 column 1 and obstacle triangle 2; at "
      "least the stated 0.25 m\n"
      "largest strain  6.25 % of edges along, across and diagonal, in frame 9, from row 1 column "
      "1 to row 2 column 1; within the stated 10 %\n"
      "knot            trefoil\n"
      "                the same in all of 3 frames certified\n"
      "verdict         nothing is wrong\n");
}

TEST(VerificationText, what_is_wrong_is_said_with_its_place) {
  EXPECT_EQ(
      verification_text("knot.rbn", all_wrong()),
      "recording       knot.rbn\n"
      "frames          9 of 12 checked; lost: 3-5; with coordinates that are no numbers: 7\n"
      "intersections   at least 6 pairs of triangles in 1 frame, most in frame 8: 6\n"
      "                frame 8 (0.12 s): ribbon row 0 column 0 and ribbon row 1 column 1\n"
      "                frame 9: ribbon row 0 column 0 and obstacle triangle 1\n"
      "smallest gap    0 m in frame 8, ribbon row 0 column 0 and ribbon row 1 column 1; LESS than "
      "the stated 0.25 m\n"
      "largest strain  65 % of edges along, across and diagonal, in frame 9, from row 1 column 1 "
      "to "
      "row 2 column 2; BEYOND the stated 10 %\n"
      "knot            trefoil\n"
      "                CHANGED 1 time; 3 frames certified\n"
      "                frame 1: trefoil\n"
      "                frame 10: unknot\n"
      "                meanwhile a particle went up to 0.12 m from frame to frame; if that is far, "
      "record more frames_per_second to be sure\n"
      "verdict         WRONG: triangles intersect, the stated gap is not kept, edges are strained "
      "beyond the limit, the knot has changed, coordinates are no numbers, frames are lost\n");
}

TEST(VerificationText, slipping_off_is_told_and_is_no_fault) {
  Verification verification = all_in_order();
  verification.outcome = {.slipped_off = Outcome::Moment{475, 9.5}, .knot_distance_m = 0.0125};
  verification.passages_over_ends = {{470, 9.4, 1, 2}, {475, std::nullopt, 2, 1}};
  const std::string text = verification_text("knot.rbn", verification);
  EXPECT_THAT(
      text,
      HasSubstr("outcome         slipped off the object at 9.50 s, the knot 12.5 mm from it\n"
                "                frame 470 (9.40 s): over an end of the object, from 1 turn to 2\n"
                "                frame 475: over an end of the object, from 2 turns to 1\n"
                "verdict         nothing is wrong\n"));
  const auto json = nlohmann::json::parse(verification_json("knot.rbn", verification));
  EXPECT_EQ(json["passed"], true);
  EXPECT_EQ(json["outcome"]["slipped_off"]["time_s"], 9.5);
  EXPECT_EQ(json["knot"]["passages_over_ends"][0]["turns_after"], 2);
}

TEST(VerificationText, strain_beyond_the_limit_is_wrong_and_strain_at_the_limit_is_not) {
  Verification verification = all_in_order();
  verification.largest_strain = {{0.1, 4, 8}, 9};
  EXPECT_THAT(verification_text("", verification), EndsWith("nothing is wrong\n"));
  verification.largest_strain = {{0.1001, 4, 8}, 9};
  EXPECT_THAT(verification_text("", verification),
              AllOf(HasSubstr("10.01 % of"), HasSubstr("; BEYOND the stated 10 %\n"),
                    EndsWith("WRONG: edges are strained beyond the limit\n")));
  EXPECT_EQ(nlohmann::json::parse(verification_json("", verification))["strain"]["kept"], false);
}

// As contact = "paper" records it.
TEST(VerificationText, strain_without_a_stated_limit_is_told_and_is_no_fault) {
  Verification verification = all_in_order();
  verification.header.limited_edges.diagonals = false;
  verification.header.strain_limit = 0;
  verification.largest_strain = {{0.65, 4, 7}, 9};
  EXPECT_THAT(verification_text("", verification),
              AllOf(HasSubstr("65 % of edges along and across, in frame 9, from row 1 column 1 to "
                              "row 2 column 1; no limit is stated\n"),
                    EndsWith("nothing is wrong\n")));
  const auto strain = nlohmann::json::parse(verification_json("", verification))["strain"];
  EXPECT_EQ(strain["edges"], nlohmann::json::array({"along", "across"}));
  EXPECT_TRUE(strain["limit"].is_null());
  EXPECT_EQ(strain["largest"], 0.65);
}

TEST(VerificationText, of_edges_that_are_not_named_nothing_is_said) {
  Verification verification = all_in_order();
  verification.header.limited_edges = {};
  verification.largest_strain.reset();
  EXPECT_THAT(
      verification_text("", verification),
      HasSubstr("largest strain  not known: the recording names no edges that are limited\n"));
  EXPECT_TRUE(verification.complaints().empty());
}

TEST(VerificationText, equal_certificates_that_know_nothing_prove_nothing) {
  Verification verification = all_in_order();
  verification.knot.certificate = "first end buried";
  verification.knot.uncertain_frames = 3;
  const std::string text = verification_text("knot.rbn", verification);
  EXPECT_THAT(text, HasSubstr("not known in 3 frames"));
  EXPECT_THAT(text, HasSubstr("WRONG: the knot cannot be certified"));
}

TEST(VerificationText, says_where_an_end_turned_too_far_and_what_helps) {
  Verification verification = all_in_order();
  EXPECT_TRUE(nlohmann::json::parse(verification_json("", verification))["knot"]["turned_too_far"]
                  .is_null());
  verification.knot.uncertain_frames = 1;
  verification.knot.turned_too_far = {31, 41, "linked -2 times", "linked -1 time", 0.25};
  EXPECT_THAT(verification_text("", verification),
              AllOf(HasSubstr("between frames 31 and 41 an end went or turned too far"),
                    HasSubstr("record more frames_per_second"),
                    EndsWith("WRONG: the knot cannot be certified\n")));
  const auto json = nlohmann::json::parse(verification_json("", verification));
  EXPECT_EQ(json["knot"]["turned_too_far"]["frame_after"], 41);
  EXPECT_EQ(json["knot"]["turned_too_far"]["after"], "linked -1 time");
  EXPECT_EQ(json["knot"]["turned_too_far"]["moved_m"], 0.25);
}

TEST(VerificationText, says_since_when_an_end_is_buried_and_whether_something_may_have_passed) {
  Verification verification = all_in_order();
  verification.knot.buried_since = 21;
  verification.knot.buried_frames = 2;
  EXPECT_THAT(
      verification_text("", verification),
      AllOf(HasSubstr("from frame 21 on an end is buried in the ribbon; its centre line has "
                      "not passed through itself since, though an end may have slipped out\n"),
            HasSubstr("the same in all of 3 frames certified\n"), EndsWith("nothing is wrong\n")));
  verification.knot.closed_anew = {"trefoil", true};
  EXPECT_THAT(verification_text("", verification),
              HasSubstr("itself since, and closed anew the last frame is the same knot\n"));
  verification.knot.closed_anew = {"unknot", false};
  EXPECT_THAT(verification_text("", verification),
              HasSubstr("itself since, and closed anew the last frame is unknot: an end has "
                        "slipped out, or lies in a loop\n"));
  EXPECT_EQ(
      nlohmann::json::parse(verification_json("", verification))["knot"]["closed_anew"]["knot"],
      "unknot");
  verification.knot.uncertain_frames = 1;
  EXPECT_THAT(verification_text("", verification),
              HasSubstr("from frame 21 on an end is buried in the ribbon\n"));
  verification.knot.may_have_passed = {30, 31, 0.25};
  EXPECT_THAT(
      verification_text("", verification),
      AllOf(HasSubstr("from frame 21 on an end is buried in the ribbon; its centre line may "
                      "have passed through itself between frames 30 and 31, where a particle "
                      "went up to 0.25 m; record more frames_per_second\n"),
            EndsWith("WRONG: the knot cannot be certified\n")));
  const auto json = nlohmann::json::parse(verification_json("", verification));
  EXPECT_EQ(json["knot"]["buried_since"], 21);
  EXPECT_EQ(json["knot"]["buried_frames"], 2);
  EXPECT_EQ(json["knot"]["may_have_passed"]["frame_after"], 31);
}

TEST(VerificationText, what_is_not_known_is_not_the_same) {
  Verification verification = all_in_order();
  verification.knot.certified_frames = 5;
  verification.knot.uncertain_frames = 3;
  EXPECT_THAT(verification_text("knot.rbn", verification),
              HasSubstr("the same in all of 2 frames certified"));
  verification.knot.uncertain_frames = 5;
  EXPECT_THAT(verification_text("knot.rbn", verification), Not(HasSubstr("the same")));
}

TEST(VerificationText, parts_are_told_below_the_whole) {
  Verification verification = all_in_order();
  verification.parts = {{{2, 6}, "reef knot", verification.knot}, {{0, 4}, "", verification.knot}};
  verification.parts[0].knot.certificate = "reef knot (6 crossings)";
  verification.parts[1].knot.certificate = "unknot";
  EXPECT_THAT(verification_text("", verification),
              HasSubstr("                the same in all of 3 frames certified\n"
                        "between         rows 2 and 6: reef knot (6 crossings)\n"
                        "                as expected: reef knot\n"
                        "                the same in all of 3 frames certified\n"
                        "between         rows 0 and 4: unknot\n"
                        "                the same in all of 3 frames certified\n"
                        "verdict         nothing is wrong\n"));
  verification.parts[0].knot.unexpected_frames = 1;
  EXPECT_THAT(verification_text("", verification),
              AllOf(HasSubstr("                NOT as expected in 1 frame: reef knot\n"),
                    EndsWith("WRONG: the knot of a part is not the one expected\n")));
  const auto parts = nlohmann::json::parse(verification_json("", verification))["knot"]["between"];
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_EQ(parts[0]["first_row"], 2);
  EXPECT_EQ(parts[0]["last_row"], 6);
  EXPECT_EQ(parts[0]["expected"], "reef knot");
  EXPECT_EQ(parts[0]["is_expected"], false);
  EXPECT_EQ(parts[0]["certificate"], "reef knot (6 crossings)");
  EXPECT_TRUE(parts[1]["is_expected"].is_null());
}

TEST(VerificationText, what_is_not_known_is_not_invented) {
  Verification nothing = all_in_order();
  nothing.smallest_gap.reset();
  nothing.largest_strain.reset();
  nothing.knot.certified_frames = 0;
  nothing.damaged = true;
  const std::string text = verification_text("knot.rbn", nothing);
  EXPECT_THAT(text, HasSubstr("smallest gap    not known\n"));
  EXPECT_THAT(text, HasSubstr("largest strain  not known\n"));
  EXPECT_THAT(text, HasSubstr("knot            not known\n"));
  EXPECT_THAT(text, HasSubstr("verdict         WRONG: the file is damaged\n"));
}

TEST(VerificationText, a_recording_that_states_no_gap_keeps_it) {
  Verification verification = all_in_order();
  verification.header.stated_gap_m = 0;
  EXPECT_TRUE(verification.complaints().empty());
  EXPECT_THAT(verification_text("knot.rbn", verification), HasSubstr("; none is stated\n"));
  EXPECT_TRUE(
      nlohmann::json::parse(verification_json("", verification))["gap"]["stated_m"].is_null());
}

TEST(VerificationJson, programs_read_what_people_read) {
  const auto json = nlohmann::json::parse(verification_json("knot.rbn", all_wrong()));
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["wrong"].size(), 6U);
  EXPECT_EQ(json["frames"]["lost"], nlohmann::json::array({3, 4, 5}));
  EXPECT_EQ(json["frames"]["not_finite"], nlohmann::json::array({7}));
  EXPECT_EQ(json["intersections"]["pairs"], 6);
  EXPECT_EQ(json["intersections"]["all_counted"], false);
  EXPECT_EQ(json["intersections"]["most"]["frame"], 8);
  EXPECT_EQ(json["intersections"]["first"][0]["between"][1]["row"], 1);
  EXPECT_EQ(json["intersections"]["first"][1]["between"][1]["obstacle_triangle"], 1);
  EXPECT_TRUE(json["intersections"]["first"][1]["time_s"].is_null());
  EXPECT_EQ(json["gap"]["kept"], false);
  EXPECT_EQ(json["gap"]["stated_m"], 0.25);
  EXPECT_EQ(json["gap"]["smallest_m"], 0);
  EXPECT_EQ(json["strain"]["between"][1]["row"], 2);
  EXPECT_EQ(json["strain"]["frame"], 9);
  EXPECT_EQ(json["strain"]["limit"], 0.1);
  EXPECT_EQ(json["strain"]["kept"], false);
  EXPECT_EQ(json["strain"]["edges"], nlohmann::json::array({"along", "across", "diagonal"}));
  EXPECT_EQ(json["knot"]["changes"][0]["after"], "unknot");
  EXPECT_EQ(nlohmann::json::parse(verification_json("", all_in_order()))["passed"], true);
}

}  // namespace ribbon::verification_text_test
