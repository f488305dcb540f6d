// Stages and hands as a scene names them.
#include "scene/stage_rules.h"

#include <gtest/gtest.h>

#include "result/refusal.h"
#include "scene/scene_files.h"
#include "scene/setting.h"

namespace ribbon::stage_rules_test {

// Lasts 4 s.
std::string fastened(const std::string& lines) {
  return smallest_scene() + "[air]\nresistance = 10\n[fastening]\nspeed = 0.5\nyield = 0.04\n" +
         lines;
}

std::string one_stage(const std::string& stage, const std::string& hand) {
  return fastened("[[stage]]\n" + stage + "[[stage.hand]]\n" + hand);
}

const std::string pulling_hand = "at = [0, 0.25]\npull = [0, 3, 4]\n";

TEST(Stages, every_key_reaches_its_place) {
  const Scene scene = read_text(fastened("[[stage]]\n"
                                         "name = 'half knot'\nuntil = 'tight'\nat_most = 3\n"
                                         "friction = 0.25\ngravity = 3\n"
                                         "[[stage.hand]]\nat = [0.25, 0.5]\npull = [0, 3, 4]\n"
                                         "speed = 0.25\nyield = 0.125\n"
                                         "[[stage.hand]]\nat = 'tip'\nhold = true\n"
                                         "[[stage]]\nuntil = 2\n"
                                         "[[stage.hand]]\nat = [0, 0.5]\npull = 'along'\n"
                                         "[[stage.hand]]\nat = [0.5, 1]\npull = 'outwards'\n"))
                          .value();
  ASSERT_EQ(scene.stages.size(), 2U);
  EXPECT_EQ(scene.stages[0],
            (StageScene{"half knot",
                        std::nullopt,
                        3,
                        0.25,
                        Eigen::Vector3d(0, -3, 0),
                        {{Span{0.25, 0.5}, HandTask::pull, {0, 0.6, 0.8}, 0.25, 0.125},
                         {Mark{"tip"}, HandTask::hold, {0, 0, 0}, 0.5, std::nullopt}}}));
  EXPECT_EQ(scene.stages[1],
            (StageScene{"stage 2",
                        2,
                        std::nullopt,
                        std::nullopt,
                        std::nullopt,
                        {{Span{0, 0.5}, HandTask::pull_along, {0, 0, 0}, 0.5, 0.04},
                         {Span{0.5, 1}, HandTask::pull_outwards, {0, 0, 0}, 0.5, 0.04}}}))
      << "what it does not say, [fastening] says";
}

TEST(Stages, a_hand_may_never_yield_though_the_others_do) {
  const auto yield = [](const std::string& line) {
    return read_text(one_stage("until = 1\n", pulling_hand + line))
        ->stages[0]
        .hands[0]
        .yield_strain;
  };
  EXPECT_EQ(yield("yield = 'never'\n"), unyielding);
  EXPECT_EQ(yield(""), 0.04);
}

TEST(Stages, a_hand_carries_along_a_path_at_heights) {
  const auto hand_of = [](const std::string& lines) {
    return read_text(one_stage("until = 'carried'\n", "at = [0, 0.25]\n" + lines))
        ->stages[0]
        .hands[0];
  };
  const HandScene named = hand_of("carry = 'over'\nheight = [[0, 0.1], [0.25, -3], [1, 0]]\n");
  EXPECT_EQ(named.task, HandTask::carry);
  EXPECT_EQ(named.carry, (CarryPath{PathId{"over"}, {{0, 0.1}, {0.25, -3}, {1, 0}}}));
  EXPECT_EQ(named.speed_m_s, 0.5);
  EXPECT_EQ(named.yield_strain, std::nullopt);
  EXPECT_EQ(hand_of("carry = [[1, 2], [3, 4]]\n").carry,
            (CarryPath{std::vector<Eigen::Vector2d>{{1, 2}, {3, 4}}, {{0, 0}}}));
  EXPECT_EQ(hand_of("carry = 'over'\nheight = 0.25\n").carry.heights,
            (std::vector<HeightAt>{{0, 0.25}}));
  const StageScene stage =
      read_text(one_stage("until = 'carried'\nat_most = 3\n", "at = [0, 1]\ncarry = 'over'\n"))
          ->stages[0];
  EXPECT_EQ(stage.goal, StageGoal::carried);
  EXPECT_EQ(stage.until_s, std::nullopt);
  EXPECT_EQ(stage.at_most_s, 3);
}

TEST(Stages, one_without_gravity_is_not_one_that_says_nothing_of_it) {
  const auto gravity_of = [](const std::string& stage) {
    const std::string text = one_stage(stage, pulling_hand) + "[gravity]\nacceleration = 9\n";
    return read_text(text)->stages.front().gravity_m_s2;
  };
  EXPECT_EQ(gravity_of(""), std::nullopt);
  EXPECT_EQ(gravity_of("gravity = 0\n"), Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(gravity_of("gravity = [0, 0, 2]\n"), Eigen::Vector3d(0, 0, 2));
}

TEST(Stages, a_scene_without_them_has_none) {
  EXPECT_TRUE(read_text(fastened(""))->stages.empty());
}

TEST(Stages, what_cannot_be_is_refused_where_it_stands) {
  struct Case {
    std::string text;
    std::string place;
    std::string words;
  };
  const std::string hand = "[[stage.hand]]\n" + pulling_hand;
  for (const Case& wrong : std::vector<Case>{
           {one_stage("", "at = [0, 1.5]\npull = [1, 0, 0]\n"), ":17:6", "from 0 to 1"},
           {one_stage("", "at = [-0.5, 0.25]\npull = [1, 0, 0]\n"), ":17:6", "from 0 to 1"},
           {one_stage("", "at = [0.5, 0.25]\npull = [1, 0, 0]\n"), ":17:6", "the smaller first"},
           {one_stage("", "pull = [1, 0, 0]\n"), ":16:1", "'at' is missing in [[stage.hand]]"},
           {one_stage("", "at = [0, 1]\npull = [0, 0, 0]\n"), ":18:8", "not all zeros"},
           {one_stage("", "at = [0, 1]\npull = 'up'\n"), ":18:8", "\"outwards\""},
           {one_stage("", "at = [0, 1]\nhold = false\n"), ":18:8", "true, or not there"},
           {one_stage("", "at = [0, 1]\nuntil = 3\n"), ":18:1", "it belongs in [[stage]]"},
           {one_stage("speed = 1\n", pulling_hand), ":16:1", "it belongs in [[stage.hand]]"},
           {one_stage("until = 0\n", pulling_hand), ":16:9", "\"carried\" or a number of seconds"},
           {one_stage("", "at = [0, 1]\n"), ":16:1", "neither pulls nor holds nor carries"},
           {one_stage("", pulling_hand + "hold = true\n"), ":19:8", "both pull and hold"},
           {one_stage("", pulling_hand + "carry = 'x'\n"), ":19:9", "both pull and carry"},
           {one_stage("", "at = [0, 1]\nhold = true\ncarry = 'x'\n"), ":19:9",
            "both hold and carry"},
           {one_stage("", pulling_hand + "height = 0.1\n"), ":19:10", "this one carries nothing"},
           {one_stage("", "at = [0, 1]\ncarry = 3\n"), ":18:9", "one line that is not empty"},
           {one_stage("", "at = [0, 1]\ncarry = [[0, 0]]\n"), ":18:9", "at least 2 points"},
           {one_stage("", "at = [0, 1]\ncarry = 'x'\nheight = [[0, 1]]\n"), ":19:10",
            "at least 2 pairs [share of the length, height]"},
           {one_stage("", "at = [0, 1]\ncarry = 'x'\nheight = [[0, 1], [0.5, 1]]\n"), ":19:20",
            "rise from 0 to 1"},
           {one_stage("until = 1\n", "at = [0, 1]\ncarry = 'x'\nyield = 0.1\n"), ":20:9",
            "a hand that carries does not yield"},
           {one_stage("until = 1\n", pulling_hand + "[[stage.hand]]\nat = [0.2, 0.3]\ncarry = "
                                                    "'x'\n"),
            ":21:6", "fight over one part"},
           {one_stage("", "at = [0, 1]\ncarry = 'x'\n"), ":15:1", "never becomes tight"},
           {one_stage("until = 'carried'\n", pulling_hand), ":16:9",
            "can never reach its goal: what nobody carries never arrives"},
           {one_stage("until = 'carried'\nat_most = 2\n", pulling_hand), ":16:9",
            "never reach its goal: what nobody carries"},
           {one_stage("until = 1\n", "at = [0, 1]\nhold = true\nyield = 0.1\n"), ":20:9",
            "does not yield"},
           {fastened("[[stage]]\nname = 'knot'\n"), ":15:1", "'knot' has no hands"},
           {one_stage("", pulling_hand + "[[stage.hand]]\nat = [0.2, 0.3]\nhold = true\n"), ":20:6",
            "fight over one part of the band: one has 0 to 0.25, the other 0.2 to 0.3"},
           {one_stage("",
                      "at = [0, 0]\npull = [1, 0, 0]\n[[stage.hand]]\nat = [0, 0]\nhold = true\n"),
            ":20:6", "fight over one part of the band: one has 0 to 0, the other 0 to 0"},
           {one_stage("",
                      "at = [0.5, 0.5001]\npull = [1, 0, 0]\n"
                      "[[stage.hand]]\nat = [0.5001, 0.5002]\nhold = true\n"),
            ":20:6", "no row of the band is left for this hand: others of 'stage 1' have"},
           {one_stage("", "at = [0, 1]\nhold = true\n"), ":15:1",
            "can never reach its goal: what nobody"},
           {one_stage("until = 5\n", pulling_hand), ":16:9", "the run is over after 4 s"},
           {one_stage("until = 4\n", pulling_hand) + "[[stage]]\n" + hand, ":20:1",
            "begins after 4 s at the earliest"},
           {one_stage("until = 1\nat_most = 2\n", pulling_hand), ":17:11", "'at_most' is for"},
           {fastened("pull = 'ends'\n[[stage]]\n" + hand), ":15:8", "scenes without stages"},
           {smallest_scene() + "[[stage]]\n" + hand, ":10:1", "[[stage]] needs [fastening]"},
           {fastened("[stage]\nname = 'x'\n"), ":15:1", "write '[[stage]]'"}}) {
    const std::string sentence = complaint(wrong.text);
    EXPECT_THAT(sentence, HasSubstr("knot.toml" + wrong.place)) << sentence;
    EXPECT_THAT(sentence, HasSubstr(wrong.words)) << sentence;
  }
}

TEST(Stages, are_as_many_as_frames_can_tell_of) {
  std::string text = fastened("");
  for (int stage = 0; stage < most_stages; ++stage)
    text += "[[stage]]\n[[stage.hand]]\n" + pulling_hand;
  EXPECT_EQ(complaint(text), "");
  EXPECT_THAT(complaint(text + "[[stage]]\n[[stage.hand]]\n" + pulling_hand),
              HasSubstr("there are too many stages; write at most 200"));
}

TEST(Stages, one_that_waits_to_be_tight_for_a_time_needs_nobody_who_pulls) {
  EXPECT_EQ(complaint(one_stage("at_most = 2\n", "at = [0, 1]\nhold = true\n")), "");
}

TEST(Stages, hands_that_meet_do_not_fight_and_those_of_other_stages_are_others) {
  EXPECT_EQ(
      complaint(one_stage("", pulling_hand + "[[stage.hand]]\nat = [0.25, 1]\nhold = true\n") +
                "[[stage]]\n[[stage.hand]]\n" + pulling_hand),
      "");
}

TEST(Stages, settings_count_them_from_1) {
  const std::string text =
      one_stage("until = 1\n", pulling_hand + "[[stage.hand]]\nat = [0.5, 1]\nhold = true\n") +
      "[[stage]]\nname = 'last'\n[[stage.hand]]\n" + pulling_hand;
  const auto changed = [&](const std::string& setting) {
    return with_setting("knot.toml", text, setting).value();
  };
  EXPECT_EQ(changed("stage[1].until=2.5"), replaced(text, "until = 1", "until = 2.5"));
  EXPECT_EQ(changed("stage[1].hand[2].at=[0.6, 1]"), replaced(text, "[0.5, 1]", "[0.6, 1]"));
  EXPECT_EQ(changed("stage[1].hand[2].at=tip"), replaced(text, "[0.5, 1]", "\"tip\""));
  EXPECT_EQ(read_text(changed("stage[2].at_most=3"))->stages[1].at_most_s, 3);
  EXPECT_EQ(read_text(changed("stage[2].hand[1].speed=3"))->stages[1].hands[0].speed_m_s, 3);
  for (const std::string nowhere : {"stage[3]", "stage[0]", "stage[1].hand[3]"})
    EXPECT_EQ(refusal_of(with_setting("knot.toml", text, nowhere + ".at=x")),
              "knot.toml: there is no '" + nowhere +
                  "' in the scene; count its tables from 1, as they stand there");
  for (const std::string wrong : {"stage[].until=2", "stage[1].until[1]=2", "stage[x].until=2"})
    EXPECT_THAT(refusal_of(with_setting("knot.toml", text, wrong)), HasSubstr("is not a setting"));
}

}  // namespace ribbon::stage_rules_test
