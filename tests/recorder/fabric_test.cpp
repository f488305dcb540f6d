// Samples in every fabric, and what a recording tells of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "obstacle/obstacle.h"
#include "playback/recording_reader.h"
#include "recorder/record.h"
#include "recorder/resume.h"
#include "recorder/run/start.h"
#include "recorder/small_scene.h"
#include "recorder/test_runs.h"
#include "scene/fabric.h"
#include "verification/frame_verifier.h"

namespace ribbon::fabric_test {

// `text` without what stands from `from` up to `to`.
std::string without(std::string text, const std::string& from, const std::string& to) {
  const std::size_t begin = text.find(from);
  return text.erase(begin, text.find(to, begin) - begin);
}

// The sample of 8 x 400 particles, which leaves open what a fabric tells.
Scene sample_in(const Fabric& fabric) {
  const std::filesystem::path file =
      std::filesystem::path(RIBBON_SAMPLES) / "overhand-hourglass-8x400.toml";
  const std::string text =
      without(without(read_file(file).value(), "mass", "\n"), "[springs]", "[air]");
  return read_scene(file, text, {"cloth.fabric=" + std::string(fabric.name)}).value();
}

class InFabric : public testing::TestWithParam<Fabric> {};

TEST_P(InFabric, a_sample_keeps_free_and_within_the_strain_limit) {
  const Scene scene = sample_in(GetParam());
  const auto obstacle = read_obstacle(scene).value();
  auto [ribbon, fastening] = find_start(scene, obstacle).value();
  EXPECT_NE(fastening.integrator(), IntegrationMethod::implicit);
  for (int step = 0; step < 10; ++step) fastening.step();
  const FrameVerifier verifier(ribbon.size(), obstacle);
  const FrameVerdict verdict = verifier.verify(fastening.positions().cast<float>());
  EXPECT_TRUE(verdict.finite);
  EXPECT_TRUE(verdict.intersections.pairs.empty());
  EXPECT_LE(fastening.strain(), 0.1);
}

INSTANTIATE_TEST_SUITE_P(All, InFabric, testing::ValuesIn(fabrics), [](const auto& fabric) {
  std::string name(fabric.param.name);
  for (char& letter : name) letter = letter == ' ' ? '_' : letter;
  return name;
});

TEST(Fabric, that_is_too_thick_for_the_particles_is_refused_with_its_place) {
  Scene scene = sample_in(fabrics[0]);
  scene.cloth->fabric.thickness_m = scene.ribbon.thickness_m = 0.04;
  const auto start = find_start(scene, std::nullopt);
  ASSERT_FALSE(start.has_value());
  EXPECT_THAT(start.error().sentence(), testing::HasSubstr("'silk' is 0.04 m thick"));
  EXPECT_THAT(start.error().sentence(), testing::HasSubstr("overhand-hourglass-8x400.toml with "));
}

// A small scene in silk, recorded under that name.
std::filesystem::path recorded(const std::string& name, const RunLimit& limit) {
  auto file = temporary_file(name);
  const std::string text = without(without(small_scene_text(), "mass", "\n"), "[springs]", "[air]");
  const Scene scene = read_scene(file, text, {"cloth.fabric=silk"}).value();
  EXPECT_TRUE(record(scene, replacing(file), goes_on, limit).has_value());
  return file;
}

TEST(Fabric, is_recorded_with_what_it_comes_to) {
  const auto reader = RecordingReader::open(recorded("silk.rbn", {.frames = 2})).value();
  EXPECT_THAT(reader.header().scene_text, testing::HasSubstr("fabric = \"silk\""));
  EXPECT_TRUE(reader.header().limited_edges.diagonals);
  ASSERT_EQ(reader.sessions().size(), 1U);
  EXPECT_THAT(reader.sessions()[0].note.changed_settings,
              testing::AllOf(testing::HasSubstr("ribbon.mass = 0.00"),
                             testing::HasSubstr("\nsprings.bend = "),
                             testing::HasSubstr("\nfriction.coefficient = 0.25\n")));
}

TEST(Fabric, goes_on_after_a_stop_as_if_there_had_been_none) {
  const auto whole = recorded("whole-silk.rbn", {});
  const auto parts = recorded("silk-in-parts.rbn", {.frames = 3});
  ASSERT_TRUE(resume(parts, "test", goes_on).has_value());
  auto one = RecordingReader::open(whole).value();
  auto other = RecordingReader::open(parts).value();
  ASSERT_EQ(one.frame_count(), other.frame_count());
  Eigen::Matrix3Xf positions;
  Eigen::Matrix3Xf same;
  ASSERT_TRUE(one.read(one.frame_count() - 1, positions).has_value());
  ASSERT_TRUE(other.read(one.frame_count() - 1, same).has_value());
  EXPECT_EQ(positions, same);
}

}  // namespace ribbon::fabric_test
