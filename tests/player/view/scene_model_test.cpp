#include "player/view/scene_model.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "player/preview/preview_renderer.h"
#include "player/render/sequence_renderer.h"
#include "player/ribbon_play.h"
#include "player/view/camera_work.h"
#include "recording/sample_recording.h"
#include "text/number_text.h"

namespace ribbon::scene_model_test {

constexpr PictureSize size{160, 120};

// The sample, so many times as large.
RecordingHeader header_of(double times) {
  RecordingHeader header = sample_header();
  header.ribbon_length_m *= times;
  header.ribbon_width_m *= times;
  header.quantisation_step_m *= times;
  header.max_position_error_m *= times;
  header.stated_gap_m *= times;
  header.obstacle->vertices *= static_cast<float>(times);
  header.input_curve *= static_cast<float>(times);
  return header;
}

void record(const std::filesystem::path& path, double times) {
  std::filesystem::remove(path);
  write_recording(path, header_of(times),
                  {times * sample_positions(40), times * sample_positions(70)});
}

// Their numbers have ranges.
bool may_have_keyframes(double times) {
  return times >= 0x1p-10 && times <= 0x1p+10;
}

// Ray traced and as previews, by cameras of each kind, and with all that has a length.
std::vector<Picture> pictures(double times) {
  const auto path = temporary_file("sized.rbn");
  record(path, times);
  RecordingReader reader = RecordingReader::open(path).value();
  View near = front_view;
  near.distance_m = static_cast<float>(3 * times);
  std::vector<Shot> shots;
  for (const View& view : {three_quarter_view, knot_view, near}) shots.push_back({view, size});
  if (may_have_keyframes(times)) {
    shots.push_back({front_view, size});
    shots.back().path =
        CameraPath::parse("time,x,y,z,distance\n0," + shortest(0.1 * times) + "," +
                              shortest(-0.2 * times) + ",0," + shortest(2 * times) + "\n",
                          "path", front_view)
            .value();
  }
  const CameraWork cameras(reader, shots);
  RenderSettings settings;
  settings.quality = *quality_named("final");
  settings.ground = true;
  settings.thickness_m = static_cast<float>(0.01 * times);
  SequenceRenderer ray_tracer(reader, settings);
  ray_tracer.set_lowest(cameras.lowest_m());
  auto preview = PreviewRenderer::create(reader, {}).value();
  EXPECT_TRUE(ray_tracer.show(0, 0.5) && preview.show(0, 0.5));
  std::vector<Picture> pictures;
  for (std::size_t shot = 0; shot < shots.size(); ++shot) {
    const Camera camera = cameras.camera(shot, {0, 0, 0.5});
    pictures.push_back(ray_tracer.picture(camera, size));
    pictures.push_back(preview.picture(camera, size).value());
  }
  return pictures;
}

TEST(SceneModel, a_scene_from_one_metre_to_two_is_its_own_model) {
  EXPECT_EQ(model_scale(header_of(1)), 1);
  EXPECT_EQ(model_scale(header_of(1.99)), 1);
  EXPECT_EQ(model_scale(header_of(2)), 0.5F);
  EXPECT_EQ(model_of(header_of(1024)).obstacle->vertices, sample_header().obstacle->vertices);
}

TEST(SceneModel, a_large_obstacle_is_in_it) {
  RecordingHeader header = sample_header();
  header.obstacle->vertices *= 100;  // then 40 m large
  EXPECT_EQ(model_scale(header), 1.0F / 32);
}

// From a billionth of a metre to a thousand billion metres, and as far again.
constexpr std::array<int, 10> powers{-60, -30, -20, -10, 1, 10, 20, 30, 40, 60};

TEST(SceneModel, pictures_of_a_scene_are_the_same_however_large_it_is) {
  const std::vector<Picture> expected = pictures(1);
  for (const int power : powers) {
    const std::vector<Picture> found = pictures(std::ldexp(1.0, power));
    EXPECT_EQ(found.size(), may_have_keyframes(std::ldexp(1.0, power)) ? 8U : 6U);
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_EQ(found[k].rgb, expected[k].rgb) << "picture " << k << " at 2^" << power;
  }
}

class SizedRecording : public RibbonPlay {
 protected:
  [[nodiscard]] std::string lines_over_it(double times) const {
    record(recording_, times);
    output_of(
        play_small("--frames 2 --overlay wireframe,obstacle-wireframe,curve --view knot "
                   "--color-by strain --force -o lines.png"));
    return bytes("lines.png");
  }
};

TEST_F(SizedRecording, has_the_same_lines_over_it) {
  const std::string expected = lines_over_it(1);
  for (const int power : powers)
    EXPECT_TRUE(lines_over_it(std::ldexp(1.0, power)) == expected) << "at 2^" << power;
}

}  // namespace ribbon::scene_model_test
