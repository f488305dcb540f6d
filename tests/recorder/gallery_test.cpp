// The drawings of the gallery tie what they are called, and begin free of intersections.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "curve/outline.h"
#include "obstacle/obstacle.h"
#include "recorder/run/drawn_knot.h"
#include "recorder/run/start.h"
#include "ribbon_mesh/marks.h"
#include "verification/frame_verifier.h"

namespace ribbon::gallery_test {

struct Tied {
  int determinant;       // |J(-1)| of the closed type, as the tables of knots have it
  std::string expected;  // by its scene
};

using Knots = std::map<std::string, Tied>;

const Knots gallery = {{"bow", {3, "bow"}},
                       {"cinquefoil", {5, "cinquefoil knot"}},
                       {"cravat", {3, "overhand knot"}},
                       {"figure-eight", {5, "figure-eight knot"}},
                       {"four-in-hand", {3, "four-in-hand"}},
                       {"gift", {3, "overhand knot"}},
                       {"granny", {9, "granny knot"}},
                       {"obi", {9, "reef knot"}},
                       {"overhand", {3, "overhand knot"}},
                       {"reef", {9, "reef knot"}},
                       {"stevedore", {9, "stevedore knot"}},
                       {"tapered", {3, "overhand knot"}},
                       {"windsor", {3, "Windsor knot"}}};

class Gallery : public testing::TestWithParam<Knots::value_type> {
 protected:
  static Scene scene() {
    const auto file =
        std::filesystem::path(RIBBON_SAMPLES) / "gallery" / (GetParam().first + ".toml");
    return with_marks_found(read_scene(file).and_then(with_outline_read).value()).value();
  }
};

RibbonMesh ribbon_of(const Scene& scene) {
  return draw_ribbon(scene, read_obstacle(scene).value()).value();
}

INSTANTIATE_TEST_SUITE_P(All, Gallery, testing::ValuesIn(gallery), [](const auto& knot) {
  std::string name = knot.param.first;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(Gallery, closes_to_the_type_of_the_books) {
  const RibbonMesh ribbon = ribbon_of(scene());
  const LaurentPolynomial jones = closed_type(diagram_of(ribbon.crossings)).value();
  std::int64_t determinant = 0;
  for (std::size_t k = 0; k < jones.coefficients.size(); ++k)
    determinant += (k % 2 == 0 ? 1 : -1) * jones.coefficients[k];
  EXPECT_EQ(std::abs(determinant), GetParam().second.determinant);
}

TEST_P(Gallery, is_the_knot_that_its_scene_expects) {
  const Scene drawn = scene();
  ASSERT_TRUE(drawn.knot.has_value());
  EXPECT_EQ(drawn.knot->expect.name, GetParam().second.expected);
  EXPECT_TRUE(check_expected_knot(drawn, ribbon_of(drawn)).has_value());
}

TEST_P(Gallery, begins_free_of_intersections_and_tied_as_drawn) {
  const Scene drawn = scene();
  const auto obstacle = read_obstacle(*drawn.obstacle).value();
  const auto start = find_start(drawn, obstacle);
  ASSERT_TRUE(start.has_value()) << start.error().sentence();
  const RibbonMesh& ribbon = start->ribbon;
  const FrameVerifier verifier(ribbon.size(), obstacle);
  const FrameVerdict verdict = verifier.verify(start->fastening.positions().cast<float>());
  EXPECT_TRUE(verdict.finite);
  EXPECT_TRUE(verdict.intersections.pairs.empty());
}

TEST(GalleryFolder, holds_no_other_scenes) {
  for (const auto& entry : std::filesystem::directory_iterator(RIBBON_SAMPLES "/gallery")) {
    const std::filesystem::path& file = entry.path();
    EXPECT_TRUE(file.extension() != ".toml" || gallery.contains(file.stem().string())) << file;
  }
}

TEST(Tapered, begins_free_of_intersections_and_as_wide_as_its_scene_says) {
  const Scene drawn =
      read_scene(std::filesystem::path(RIBBON_SAMPLES) / "gallery/tapered.toml").value();
  const auto obstacle = read_obstacle(*drawn.obstacle).value();
  const auto start = find_start(drawn, obstacle);
  ASSERT_TRUE(start.has_value()) << start.error().sentence();
  const Eigen::Matrix3Xf positions = start->fastening.positions().cast<float>();
  const RestSize size = start->ribbon.size();
  EXPECT_TRUE(FrameVerifier(size, obstacle).verify(positions).intersections.pairs.empty());
  for (const int row : {0, size.grid.along - 1}) {
    const auto particles = positions.middleCols(size.grid.particle(row, 0), size.grid.across);
    const double width_m = (particles.rightCols<1>() - particles.leftCols<1>()).norm();
    EXPECT_NEAR(width_m / size.row_width_m(row), 1, 0.1);
  }
}

}  // namespace ribbon::gallery_test
