// What the player shows of a small recording, beside pictures that are kept.
#include "player/reference_pictures.h"

#include <cmath>
#include <ostream>

#include "player/picture/png_encoder.h"
#include "player/render/sequence_renderer.h"
#include "player/ribbon_play.h"
#include "player/view/camera_work.h"

namespace ribbon::reference_pictures_test {

namespace fs = std::filesystem;

// A loop whose ends cross before an octahedron; it becomes wider from frame to frame.
Eigen::Matrix3Xd looped(const RibbonGrid& grid, int frame) {
  const double crossing = 0.62 + 0.02 * frame;  // where it meets itself, of the way from the middle
  Eigen::Matrix3Xd positions(3, grid.particle_count());
  for (int p = 0; p < grid.particle_count(); ++p) {
    const double t = 2.0 * grid.row(p) / (grid.along - 1) - 1;
    const double across = 0.1 * (grid.column(p) / (grid.across - 1.0) - 0.5);
    const Eigen::Vector2d along(3 * t * t - crossing * crossing, -1.4 * t);
    const Eigen::Vector2d sideways = Eigen::Vector2d(-along.y(), along.x()).normalized() * across;
    positions.col(p) << 0.7 * t * (t * t - crossing * crossing) + sideways.x(),
        0.3 - 0.7 * t * t + sideways.y(), 0.16 + 0.05 * t + 0.3 * across * std::sin(7 * t);
  }
  return positions;
}

RecordingHeader looped_header() {
  RecordingHeader header = sample_header();
  const RibbonGrid grid{80, 6};
  header.grid = grid;
  header.uv.resize(2, grid.particle_count());
  header.input_curve.resize(3, 20);
  for (int p = 0; p < grid.particle_count(); ++p)
    header.uv.col(p) << static_cast<float>(grid.row(p)) / 79.0F,
        static_cast<float>(grid.column(p)) / 5.0F;
  for (int i = 0; i < 20; ++i)
    header.input_curve.col(i) = looped(grid, 0).col(grid.particle(4 * i, 3)).cast<float>();
  return header;
}

class Reference : public RibbonPlay {
 protected:
  Reference() {
    const RecordingHeader header = looped_header();
    write_recording(folder_ / "loop.rbn", header, {looped(header.grid, 0), looped(header.grid, 1)});
    Picture squares = blank_picture({8, 8}, from_srgb(0xE8C040));
    for (int i = 0; i < 2; ++i)
      fill({4 * i, 4 * i, 4 * i + 4, 4 * i + 4}, from_srgb(0x206090), 1, squares);
    EXPECT_TRUE(write_png(folder_ / "squares.png", squares).has_value());
  }

  // The second frame.
  [[nodiscard]] Picture play_loop(std::string options) const {
    if (options.find("--size") == std::string::npos) options += " --size 160x120";
    output_of(run("loop.rbn --frames 2 --quiet --force -o shown.png " + options));
    return read_png(folder_ / "shown.png");
  }
};

struct Shown {
  const char* name;
  const char* options;
};

std::ostream& operator<<(std::ostream& stream, const Shown& shown) {
  return stream << shown.options;
}

class Kept : public Reference, public testing::WithParamInterface<Shown> {};

TEST_P(Kept, picture_is_shown) {
  const ReferencePictures references(RIBBON_REFERENCES, RIBBON_REFERENCES_FOUND);
  EXPECT_TRUE(references.shows(GetParam().name, play_loop(GetParam().options)));
}

// With vector instructions that every machine has.
INSTANTIATE_TEST_SUITE_P(
    Reference, Kept,
    testing::Values(
        Shown{"draft", "--isa sse2 --quality draft"},
        Shown{"standard", "--isa sse2 --quality standard"},
        Shown{"final", "--isa sse2 --quality final"},
        Shown{"ground", "--isa sse2 --ground --view azimuth=150,elevation=30"},
        Shown{"texture", "--isa sse2 --texture squares.png"},
        Shown{"thickness", "--isa sse2 --thickness 12 --view knot"},
        Shown{"strain", "--isa sse2 --color-by strain --color-range 0:200 --size 240x180"},
        Shown{"contact", "--isa sse2 --color-by contact --view knot --size 240x180"},
        Shown{"overlay", "--isa sse2 --overlay wireframe,obstacle-wireframe,curve,frame"},
        Shown{"preview", "--preview --samples 4"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(Reference, the_tolerance_admits_other_vector_instructions) {
  const std::string options = "--quality standard --view knot";
  const Picture plain = play_loop(options + " --isa sse2");
  EXPECT_TRUE(is_within_tolerance(difference(play_loop(options), plain)));
}

Picture in_light(const fs::path& recording, const Lighting& lighting, const Backdrop& backdrop) {
  auto reader = RecordingReader::open(recording).value();
  SequenceRenderer renderer(reader, {*quality_named("standard"), lighting, backdrop});
  EXPECT_TRUE(renderer.show(1).has_value());
  const PictureSize size{160, 120};
  return renderer.picture(CameraWork(reader, {{three_quarter_view, size}}).camera(0, {1, 0}), size);
}

TEST_F(Reference, the_tolerance_does_not_admit_a_light_that_has_moved_or_another_colour) {
  const fs::path loop = folder_ / "loop.rbn";
  const Picture shown = in_light(loop, {}, {});
  Lighting moved;
  moved.sun_direction = (moved.sun_direction + Eigen::Vector3f(0.05F, 0, 0)).normalized();
  EXPECT_FALSE(is_within_tolerance(difference(in_light(loop, moved, {}), shown)));
  Backdrop tinted;
  tinted.top = from_srgb(0xDDE2F0);
  EXPECT_FALSE(is_within_tolerance(difference(in_light(loop, {}, tinted), shown)));
}

TEST_F(Reference, a_missing_one_is_written_and_fails) {
  const ReferencePictures references(folder_, folder_ / "found");
  const Picture picture = blank_picture({8, 8}, from_srgb(0x808080));
  const auto answer = references.shows("missing", picture);
  EXPECT_FALSE(answer);
  EXPECT_THAT(answer.message(), HasSubstr("found/missing.png"));
  EXPECT_EQ(read_png(folder_ / "found/missing.png").rgb, picture.rgb);
}

TEST_F(Reference, one_that_is_not_matched_shows_the_difference) {
  const ReferencePictures references(folder_, folder_ / "found");
  const Picture got = blank_picture({8, 8}, from_srgb(0x808080));
  const auto answer = references.shows("squares", got);
  EXPECT_FALSE(answer);
  EXPECT_THAT(answer.message(), HasSubstr("found/squares-difference.png"));
  EXPECT_EQ(read_png(folder_ / "found/squares-got.png").rgb, got.rgb);
  EXPECT_EQ(names("found"), (std::set<std::string>{"squares-got.png", "squares-difference.png"}));
  EXPECT_TRUE(references.shows("squares", read_png(folder_ / "squares.png")));
  EXPECT_FALSE(references.shows("squares", blank_picture({8, 9}, from_srgb(0x808080))));
}

}  // namespace ribbon::reference_pictures_test
