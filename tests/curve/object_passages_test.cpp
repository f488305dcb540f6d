#include "curve/object_passages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "curve/space_curve.h"
#include "result/refusal.h"

namespace ribbon::object_passages_test {

constexpr double width_m = 0.2;
constexpr double wide_m = 2;  // too wide to turn round a block 9 high
constexpr double clearance_m = 0.02;

using Points = std::vector<Eigen::Vector2d>;

// In front of a block two units wide to the right, round it and back behind it.
const Points wrap = {{-9, -0.5}, {-3, -0.5}, {3, -0.5}, {7, -0.5}, {9, 0},
                     {7, 0.5},   {3, 0.5},   {-3, 0.5}, {-9, 0.5}};

// Its end then crosses its beginning, at (-6, -0.5).
const Points crossed_wrap = {{-9, -0.5}, {-3, -0.5}, {3, -0.5}, {7, -0.5}, {9, 0},  {7, 0.5},
                             {3, 0.5},   {-3, 0.5},  {-5, 0.4}, {-6, 0},   {-6, -4}};

ObjectHeights block(double half_height) {
  return [half_height](const Eigen::Vector2d& place) -> std::optional<HeightRange> {
    if (place.cwiseAbs().maxCoeff() > 1) return std::nullopt;
    return HeightRange{-half_height, half_height};
  };
}

CurveScene scene_of(const Points& points, const std::string& letters) {
  CurveScene scene;
  scene.drawing = DrawnPoints{points};
  scene.unit_m = 1;
  scene.clearance_m = clearance_m;
  if (!letters.empty()) scene.crossings = CrossingList{letters, "knot.toml:3:13"};
  return scene;
}

Result<SpaceCurve> curve_of(const Points& points, const std::string& letters,
                            const ObjectHeights& object = block(0.5),
                            double ribbon_width_m = width_m,
                            TightPassage tight = TightPassage::refuse) {
  return generate_space_curve(scene_of(points, letters), {.width_m = ribbon_width_m, .along = 2001},
                              tight, object);
}

// The number in a sentence before these words.
double number_before(const std::string& words, const std::string& sentence) {
  const std::size_t end = sentence.find(words);
  const std::size_t begin = sentence.rfind(' ', end - 1);
  return end == std::string::npos ? 0 : std::stod(sentence.substr(begin + 1, end - begin));
}

std::string refusal(const Points& points, const std::string& letters,
                    const ObjectHeights& object = block(0.5)) {
  return refusal_of(curve_of(points, letters, object));
}

TEST(ObjectRuns, begin_and_end_at_the_outline) {
  const auto runs = find_object_runs(wrap, block(0.5));
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_NEAR(runs[0].from.x(), -1, 0.02);
  EXPECT_NEAR(runs[0].to.x(), 1, 0.02);
  EXPECT_NEAR(runs[1].begin, 6 + 2.0 / 6, 0.01);
  EXPECT_NEAR(runs[1].end, 6 + 4.0 / 6, 0.01);
  EXPECT_EQ(runs[1].object.high, 0.5);
}

TEST(ObjectRuns, hold_the_highest_and_lowest_place_on_the_way) {
  const ObjectHeights slope = [](const Eigen::Vector2d& place) -> std::optional<HeightRange> {
    if (std::abs(place.x()) > 1) return std::nullopt;
    return HeightRange{place.x() - 1, place.x()};
  };
  const auto runs = find_object_runs({{-3, 0}, {3, 0}}, slope);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_NEAR(runs[0].object.low, -2, 0.01);
  EXPECT_NEAR(runs[0].object.high, 1, 0.01);
}

// Of the part of the curve with that z, in front of or behind the block and what it is level for.
HeightRange heights_over_block(const SpaceCurve& curve, double z_sign) {
  HeightRange range{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
  for (const auto& point : curve.points.colwise())
    if (std::abs(point.x()) <= 1 + 0.45 * width_m && point.z() * z_sign > 0)
      range.include({point.y(), point.y()});
  return range;
}

TEST(ObjectPassages, keep_half_the_width_and_the_clearance_from_the_object) {
  const double distance_m = width_m / 2 + clearance_m;
  for (const bool first_in_front : {true, false}) {
    const auto curve = curve_of(wrap, first_in_front ? "FB" : "BF").value();
    const double front = first_in_front ? -1 : 1;
    EXPECT_GE(heights_over_block(curve, front).low, 0.5 + distance_m - 1e-9);
    EXPECT_LE(heights_over_block(curve, -front).high, -0.5 - distance_m + 1e-9);
    EXPECT_LE(heights_over_block(curve, front).high, 0.5 + distance_m + 0.001);
    ASSERT_EQ(curve.objects.size(), 2U);
    EXPECT_EQ(curve.objects[0].in_front, first_in_front);
  }
}

TEST(ObjectPassages, are_listed_with_the_crossings_in_the_order_of_the_walk) {
  const auto curve = curve_of(crossed_wrap, "OFBU").value();
  EXPECT_TRUE(curve.crossings.at(0).first_over);
  EXPECT_EQ(letters_of(curve.crossings, curve.objects), "OFBU");
  EXPECT_EQ(refusal(crossed_wrap, "UFBO"), "");
}

TEST(ObjectPassages, the_object_is_not_asked_for_where_the_scene_does_not_tell_of_it) {
  const ObjectHeights none_asks = [](const Eigen::Vector2d&) -> std::optional<HeightRange> {
    ADD_FAILURE();
    return std::nullopt;
  };
  for (const char* letters : {"", "OU"})
    EXPECT_EQ(curve_of(crossed_wrap, letters, none_asks)->points,
              curve_of(crossed_wrap, letters, {})->points);
}

TEST(ObjectPassages, a_run_without_a_letter_is_told_with_its_two_places) {
  EXPECT_THAT(refusal(wrap, "F"),
              AllOf(StartsWith("knot.toml:3:13: the curve passes the object from (1, 0.5) to "),
                    HasSubstr("(-1, 0.5) of the drawing, and 'crossings' ends before; write F as "
                              "letter 2 if it lies in front, B if behind")));
  EXPECT_THAT(refusal(crossed_wrap, "OFU"), HasSubstr("but letter 3 of 'crossings' is U"));
}

TEST(ObjectPassages, a_letter_without_a_run_is_told_with_the_crossing_that_is_there) {
  EXPECT_THAT(refusal(crossed_wrap, "FOBU"),
              AllOf(HasSubstr("passage 1 is the crossing at (-6, -0.5) of the drawing"),
                    HasSubstr("letter 1 of 'crossings' is F")));
  EXPECT_THAT(refusal(crossed_wrap, "OFB"), HasSubstr("passage 4 is the crossing at (-6, -0.5)"));
  EXPECT_THAT(refusal(wrap, "FBF"),
              HasSubstr("letter 3 of 'crossings' is F, but the drawing has 2 passages"));
  EXPECT_THAT(refusal(wrap, "FBO"), HasSubstr("letter 3 of 'crossings' is O"));
}

TEST(ObjectPassages, both_letters_of_a_crossing_are_counted_among_all) {
  EXPECT_THAT(refusal(crossed_wrap, "OFBO"),
              HasSubstr("passages 1 and 4 meet at (-6, -0.5) of the drawing, and both say O"));
}

TEST(ObjectPassages, of_all_lists_as_long_those_that_fit_are_taken_and_the_others_told_where) {
  int taken = 0;
  for (int list = 0; list < 256; ++list) {
    std::string letters;
    for (int k = 0; k < 4; ++k) letters += "OUFB"[list >> (2 * k) & 3];
    const bool tells_of_object = letters.find_first_of("FB") != std::string::npos;
    const auto curve = curve_of(crossed_wrap, letters);
    if (curve) {
      ++taken;
      EXPECT_EQ(letters_of(curve->crossings, curve->objects), letters);
    } else if (tells_of_object) {
      EXPECT_THAT(curve.error().sentence(), StartsWith("knot.toml:3:13: ")) << letters;
    }
  }
  EXPECT_EQ(taken, 8);
}

TEST(ObjectPassages, without_an_object_are_refused) {
  EXPECT_THAT(refusal(wrap, "FB", {}),
              AllOf(StartsWith("knot.toml:3:13: "), HasSubstr("add [obstacle]")));
}

TEST(ObjectPassages, an_end_before_the_object_is_told) {
  Points short_wrap = wrap;
  short_wrap.pop_back();
  short_wrap.back() = {0, 0.5};
  EXPECT_THAT(refusal(short_wrap, "FB"),
              AllOf(StartsWith("drawing at (0, 0.5)"), HasSubstr("lead it out")));
}

TEST(ObjectPassages, a_curve_that_meets_the_object_only_once_smoothed_is_told) {
  const Points near = {{-9, -0.5}, {-3, -0.5}, {3, -0.5}, {7, 2},
                       {7, 6},     {3, 1.1},   {-3, 1.1}, {-7, 6}};
  EXPECT_THAT(refusal(near, "F"), HasSubstr("passes the object otherwise than drawn"));
}

TEST(ObjectPassages, a_turn_too_short_for_the_object_is_told_and_how_long_it_must_be) {
  EXPECT_THAT(refusal(wrap, "FB", block(9)),
              AllOf(StartsWith("drawing at (1, 0.5), in metres (1, 0.5): "),
                    HasSubstr("the way from the end of passage 1 to the begin of passage "
                              "2 is "),
                    HasSubstr("that passes the object; draw it "),
                    HasSubstr("drawing units long, or make the object smaller")));
  EXPECT_THAT(refusal_of(curve_of(wrap, "FB", block(4.5), wide_m)),
              HasSubstr("or set ribbon.width to 0."));
}

// In front of the block to the right, round `x` and back behind it.
Points wrap_to(double x) {
  return {{-9, -0.4}, {-5, -0.4}, {0.4, -0.4}, {x, 0}, {0.4, 0.4}, {-5, 0.4}, {-9, 0.4}};
}

// From the block's outline round the turn and back to it, in the plan.
double way_round(const Points& points) {
  const Eigen::Matrix3Xd curve = curve_of(points, "FB", block(0.001), 0.001).value().points;
  double way = 0;
  for (Eigen::Index i = 1; i < curve.cols(); ++i)
    if (curve(0, i - 1) > 1)
      way += std::hypot(curve(0, i) - curve(0, i - 1), curve(2, i) - curve(2, i - 1));
  return way;
}

TEST(ObjectPassages, nearer_than_a_width_are_told_as_drawn_from_outline_to_outline) {
  for (const std::string letters : {"FB", "BF"}) {
    const std::string refused = refusal_of(curve_of(wrap_to(1.2), letters, block(0.5), 0.8));
    EXPECT_THAT(refused, HasSubstr("too short for a ribbon 0.8 m wide that passes the object"));
    EXPECT_NEAR(number_before(" m long", refused), way_round(wrap_to(1.2)), 0.05) << refused;
    const double told = number_before(" drawing units long", refused);
    double x = 1.2;
    while (x < 5 && !curve_of(wrap_to(x), letters, block(0.5), 0.8)) x += 0.02;
    EXPECT_NEAR(way_round(wrap_to(x)), told, 0.05 * told) << "what was told is what is needed";
  }
}

TEST(ObjectPassages, what_lies_behind_passes_over_nothing_that_lies_in_front) {
  const Points across = {{-30, 0}, {-10, 0}, {-3, 0}, {3, 0}, {10, 0}, {20, 0},  {28, 8}, {20, 20},
                         {8, 24},  {0, 16},  {0, 10}, {0, 3}, {0, -3}, {0, -10}, {0, -30}};
  EXPECT_TRUE(curve_of(across, "FOBU"));
  EXPECT_EQ(refusal(across, "BOFU"),
            "drawing at (0, 0): passage 2 lies behind the object and passage 4, over which it is "
            "to pass, in front of it; exchange over and under there, or front and behind");
}

TEST(ObjectPassages, are_squeezed_only_where_some_ribbon_would_have_room) {
  EXPECT_TRUE(
      curve_of(wrap, "FB", block(4.5), wide_m, TightPassage::squeeze)->squeezed.has_value());
  EXPECT_THAT(refusal_of(curve_of(wrap, "FB", block(9), wide_m, TightPassage::squeeze)),
              HasSubstr("that passes the object"));
}

// The wrap as two strokes that meet between the block and the turn.
Result<std::vector<ObjectPassage>> drawn_as(Depth first, Depth second,
                                            const Points& points = wrap) {
  const auto meeting = points.begin() + 2;
  return joined({{{points.begin(), meeting + 1}, first}, {{meeting, points.end()}, second}})
      .and_then([](const JoinedDrawing& drawing) {
        return object_passages({}, drawing, {}, block(0.5));
      });
}

TEST(ObjectPassages, lie_behind_where_the_stroke_says_so_and_else_in_front) {
  EXPECT_EQ(letters_of({}, drawn_as(Depth::untold, Depth::behind).value()), "FB");
  EXPECT_EQ(letters_of({}, drawn_as(Depth::behind, Depth::untold).value()), "BF");
  EXPECT_EQ(letters_of({}, drawn_as(Depth::front, Depth::untold).value()), "FF");
}

TEST(ObjectPassages, a_stroke_behind_nothing_is_told_with_its_place) {
  Points beside = wrap;
  for (Eigen::Vector2d& point : beside)
    if (point.y() > 0) point.y() += 2;
  EXPECT_THAT(refusal_of(drawn_as(Depth::untold, Depth::behind, beside)),
              AllOf(StartsWith("drawing at ("), HasSubstr("this part is drawn behind the object, "
                                                          "but does not pass it")));
}

}  // namespace ribbon::object_passages_test
