#include "recorder/run/start.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "recorder/run/drawn_knot.h"
#include "result/refusal.h"
#include "text/number_text.h"

namespace ribbon::start_test {

// A trefoil 60 cm across, whose tails are shorter than half of the ribbon's width.
Scene scene_with_short_tails() {
  std::string points;
  constexpr double begin = 1.777;
  constexpr double end = 0.317 + 2 * std::numbers::pi;
  for (int i = 0; i < 80; ++i) {
    const double t = begin + (end - begin) * i / 79;
    points += (i > 0 ? ", [" : "[") + short_number(std::sin(t) + 2 * std::sin(2 * t), 6) + ", " +
              short_number(std::cos(t) - 2 * std::cos(2 * t), 6) + "]";
  }
  return read_scene("trefoil.toml", "[curve]\npoints = [" + points +
                                        "]\nunit = 0.1\n[ribbon]\nwidth = 0.4268\nalong = 40\n"
                                        "across = 3\n[springs]\nstretch = 232\nshear = 55.36\n"
                                        "[time]\nduration = 1\n")
      .value();
}

// Where letting go of strain would draw a short end out of its knot, the ribbon keeps its strain.
TEST(Start, of_a_ribbon_with_short_tails_is_tied_as_drawn) {
  const Scene scene = scene_with_short_tails();
  const RibbonMesh drawn = draw_ribbon(scene).value();
  const auto relaxed = FasteningProcessor::create(scene, drawn, std::nullopt).value();
  EXPECT_THAT(refusal_of(check_first_frame(scene, drawn, relaxed.positions())),
              HasSubstr("is tied as: unknot"));
  const auto start = find_start(scene, std::nullopt);
  ASSERT_TRUE(start) << start.error().sentence();
  EXPECT_EQ(refusal_of(check_first_frame(scene, drawn, start->fastening.positions())), "");
}

}  // namespace ribbon::start_test
