#include "converter/output_verification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "files/files.h"
#include "files/flipped.h"
#include "model/sample_knot.h"
#include "model/sample_picture.h"
#include "recording/sample_recording.h"
#include "result/refusal.h"

namespace ribbon::output_verification_test {

namespace fs = std::filesystem;

// One of each format; those with a number are sequences.
constexpr std::array outputs{"a.abc", "a.fbx",  "a.glb",         "a.mdd",        "a.npy",
                             "a.pc2", "a.usda", "a.{frame}.obj", "b.{frame}.fbx"};

bool holds_faces(const std::string& output) {
  return !output.ends_with(".mdd") && !output.ends_with(".npy") && !output.ends_with(".pc2");
}

bool holds_rate(const std::string& output) {
  return output != "a.npy" && output != "a.pc2" && output.find('{') == std::string::npos;
}

class OutputVerification : public TestInFolder {
 protected:
  OutputVerification() { record(knot_); }

  void record(const SampleKnot& knot) const {
    write_recording(folder_ / "knot.rbn", knot.header, knot.frames);
  }

  [[nodiscard]] ConversionRequest request(const std::string& output) const {
    return {.recording = folder_ / "knot.rbn",
            .output = folder_ / output,
            .frames = "",
            .model = model_,
            .start_frame = std::nullopt,
            .force = true,
            .progress = ProgressStyle::none};
  }

  void write_all() const {
    for (const std::string output : outputs)
      EXPECT_EQ(refusal_of(convert(request(output))), "") << output;
  }

  [[nodiscard]] VerificationReport report(const std::string& output,
                                          std::optional<double> tolerance_m = std::nullopt) const {
    return verify_output(request(output), tolerance_m).value();
  }

  // What is said of the files where something else was recorded than they hold.
  void expect_all_differ(const SampleKnot& other, const std::string& part,
                         bool (*concerned)(const std::string& output)) const {
    record(other);
    for (const std::string output : outputs) {
      const VerificationReport found = report(output);
      EXPECT_NE(found.deviations.good(), concerned(output)) << output;
      if (!concerned(output)) continue;
      EXPECT_THAT(verification_text(found), HasSubstr(part)) << output;
    }
  }

  // Without waiting for the disk, as where a file is written over.
  static void spoil(const fs::path& file, const std::string& bytes) {
    fs::remove(file);
    std::ofstream(file, std::ios::binary) << bytes;
  }

  static bool all(const std::string&) { return true; }

  SampleKnot knot_ = sample_knot();
  ModelSettings model_;
};

TEST_F(OutputVerification, what_was_written_is_as_recorded) {
  write_all();
  for (const std::string output : outputs) {
    const VerificationReport found = report(output);
    EXPECT_TRUE(found.deviations.good()) << verification_text(found);
    EXPECT_EQ(found.deviations.frames, 5) << output;
    if (output == "a.glb") continue;  // rounds
    EXPECT_THAT(verification_text(found), EndsWith("5 frames: exactly as recorded"));
  }
}

TEST_F(OutputVerification, so_it_is_a_kilometre_away) {
  knot_ = sample_knot({.along = 12, .across = 4}, {1000, 2000, -3000});
  record(knot_);
  write_all();
  for (const std::string output : outputs)
    EXPECT_TRUE(report(output).deviations.good()) << verification_text(report(output));
}

TEST_F(OutputVerification, so_it_is_where_the_ribbon_comes_from_far_away) {
  knot_.header.max_position_error_m = knot_.header.quantisation_step_m = 0;
  knot_.frames[0].colwise() += Eigen::Vector3d(1000.1, 2000.2, -3000.3);
  knot_.frames[3].array() *= 1e-9;
  record(knot_);
  write_all();
  for (const std::string output : outputs)
    EXPECT_TRUE(report(output).deviations.good()) << verification_text(report(output));
}

TEST_F(OutputVerification, so_it_is_beside_a_picture_of_any_name) {
  ASSERT_TRUE(write_file(folder_ / "cloth.png", sample_png()));
  for (const std::string output : {"a@b.usda", "c@@@@d@.e.usda"}) {
    ConversionRequest textured = request(output);
    textured.texture = folder_ / "cloth.png";
    ASSERT_EQ(refusal_of(convert(textured)), "");
    const VerificationReport found = verify_output(textured, std::nullopt).value();
    EXPECT_TRUE(found.deviations.good()) << verification_text(found);
  }
}

TEST_F(OutputVerification, other_axes_units_and_faces_are_known) {
  model_ = {.faces = RibbonFaces::quads,
            .placement = {.up = UpAxis::z, .metres_per_unit = 0.01, .scale = 3}};
  write_all();
  for (const std::string output : outputs)
    EXPECT_TRUE(report(output).deviations.good()) << verification_text(report(output));
}

TEST_F(OutputVerification, a_thickness_is_known) {
  knot_.header.obstacle.reset();
  knot_.frames.erase(knot_.frames.begin() + 2);  // a pinched ribbon is no solid
  record(knot_);
  model_ = {.thickness_m = 0.002, .placement = {.metres_per_unit = 0.01}};
  for (const std::string output : {"a.abc", "a.fbx", "a.glb", "a.pc2", "a.usda"}) {
    ASSERT_EQ(refusal_of(convert(request(output))), "") << output;
    EXPECT_TRUE(report(output).deviations.good()) << verification_text(report(output));
  }
}

TEST_F(OutputVerification, files_with_normals_are_read_back) {
  model_.with_normals = true;
  for (const std::string output : {"a.abc", "a.fbx", "a.glb", "a.usda"}) {
    ASSERT_EQ(refusal_of(convert(request(output))), "") << output;
    EXPECT_TRUE(report(output).deviations.good()) << verification_text(report(output));
  }
}

TEST_F(OutputVerification, a_vertex_that_has_moved_is_found_with_its_frame) {
  write_all();
  knot_.frames[3](1, 17) += 1e-4;
  expect_all_differ(knot_, " m from the recording, in frame 4; only ", all);
}

TEST_F(OutputVerification, what_is_tolerated_is_up_to_the_user) {
  write_all();
  knot_.frames[3](1, 17) += 1e-4;
  record(knot_);
  for (const std::string output : outputs) {
    EXPECT_TRUE(report(output, 1.2e-4).deviations.good()) << output;
    EXPECT_FALSE(report(output, 0.8e-4).deviations.good()) << output;
  }
}

TEST_F(OutputVerification, frames_that_came_later_are_not_looked_for) {
  for (const std::string output : outputs) {
    record(knot_);
    ConversionRequest written = request(output);
    written.frame_count = convert(written).value().frame_count;
    SampleKnot longer = knot_;
    longer.frames.push_back(sample_wave(knot_.header.grid, 1.5));
    record(longer);
    const VerificationReport found = verify_output(written, std::nullopt).value();
    EXPECT_EQ(found.deviations.frames, 5) << output;
    EXPECT_TRUE(found.deviations.good()) << output << ": " << verification_text(found);
  }
}

TEST_F(OutputVerification, swapped_frames_are_found) {
  write_all();
  knot_.frames[1].swap(knot_.frames[4]);
  expect_all_differ(knot_, "in frame ", all);
}

TEST_F(OutputVerification, another_unit_or_axis_is_found) {
  write_all();
  for (const Placement& placement :
       {Placement{.metres_per_unit = 0.01}, Placement{.up = UpAxis::z}, Placement{.scale = 1.01}}) {
    model_.placement = placement;
    for (const std::string output : outputs)
      EXPECT_FALSE(report(output).deviations.good()) << output;
  }
}

TEST_F(OutputVerification, another_frame_rate_is_found_where_it_is_told) {
  write_all();
  knot_.header.frames_per_second = 49;
  expect_all_differ(knot_, "says another frame rate", holds_rate);
}

TEST_F(OutputVerification, another_uv_is_found) {
  write_all();
  knot_.header.uv(0, 7) += 0.001F;
  expect_all_differ(knot_, "other uv in 'first knot'", [](const std::string& output) {
    return output != "a.npy";  // of point caches, in the mesh that they deform
  });
}

TEST_F(OutputVerification, another_obstacle_is_found) {
  write_all();
  knot_.header.obstacle->vertices(1, 3) += 0.01F;
  expect_all_differ(knot_, "0.01 m from the recording, in the obstacle",
                    [](const std::string& output) { return output != "a.npy"; });
}

TEST_F(OutputVerification, faces_along_other_diagonals_are_found) {
  model_.faces = RibbonFaces::quads;
  write_all();
  model_.faces = RibbonFaces::triangles;
  for (const std::string output : outputs)
    EXPECT_EQ(report(output).deviations.good(), output == "a.npy") << output;
}

TEST_F(OutputVerification, a_frame_more_is_found) {
  write_all();
  knot_.frames.pop_back();
  record(knot_);
  for (const std::string output : outputs)
    EXPECT_EQ(report(output).deviations.good(), output.find('{') != std::string::npos) << output;
}

TEST_F(OutputVerification, a_missing_file_is_found) {
  write_all();
  ASSERT_TRUE(fs::remove(folder_ / "a.0003.obj"));
  EXPECT_THAT(verification_text(report("a.{frame}.obj")),
              AllOf(HasSubstr("a.0003.obj"), HasSubstr("cannot be read back")));
  ASSERT_TRUE(fs::remove(folder_ / "a.obj"));
  EXPECT_THAT(verification_text(report("a.pc2")), HasSubstr("a.obj"));
}

// A file that may hold anything: said to be something else, or to hold the same; never more than
// that.
TEST_F(OutputVerification, a_file_that_was_cut_off_is_found_at_every_length) {
  write_all();
  for (const std::string output :
       {"a.abc", "a.fbx", "a.glb", "a.mdd", "a.npy", "a.pc2", "a.usda"}) {
    const std::string bytes = read_file(folder_ / output).value();
    const std::size_t last = bytes.find_last_not_of(" }\n");  // of USD, as far as it says something
    for (std::size_t length = 0; length < std::min(last, bytes.size()); length += 1 + length / 25) {
      spoil(folder_ / output, bytes.substr(0, length));
      const bool says_all = output == "a.fbx" && length > bytes.size() - 600;  // takes, and the end
      EXPECT_TRUE(says_all || !report(output).deviations.good()) << output << " " << length;
    }
  }
}

TEST_F(OutputVerification, changed_bytes_are_differences_or_mean_nothing) {
  write_all();
  for (const std::string output : outputs) {
    const fs::path file = folder_ / (output == "a.{frame}.obj"   ? "a.0002.obj"
                                     : output == "b.{frame}.fbx" ? "b.0002.fbx"
                                                                 : output);
    const std::string bytes = read_file(file).value();
    int found = 0;
    for (std::size_t at = 0; at < bytes.size(); at += 1 + bytes.size() / 97) {
      spoil(file, flipped(bytes, at, 0x14));
      found += report(output).deviations.good() ? 0 : 1;
    }
    EXPECT_GT(found, 30) << output;
  }
}

TEST_F(OutputVerification, a_number_beyond_all_bounds_is_a_difference) {
  write_all();
  std::string usd = read_file(folder_ / "a.usda").value();
  for (const std::string list : {"int[] faceVertexIndices = [", "int[] faceVertexCounts = ["}) {
    const std::size_t at = usd.find(list);
    ASSERT_NE(at, std::string::npos);
    spoil(folder_ / "a.usda", usd.insert(at + list.size(), "1e300, "));
    EXPECT_THAT(verification_text(report("a.usda")), HasSubstr("cannot be read back")) << list;
  }
}

TEST_F(OutputVerification, the_obstacle_alone_is_compared) {
  model_.with_ribbon = false;
  for (const std::string output : {"rock.obj", "rock.fbx"}) {
    ASSERT_TRUE(convert(request(output)));
    EXPECT_THAT(verification_text(report(output)), EndsWith("exactly as recorded"));
  }
  knot_.header.obstacle->vertices(1, 3) += 0.01F;
  record(knot_);
  for (const std::string output : {"rock.obj", "rock.fbx"})
    EXPECT_THAT(verification_text(report(output)), HasSubstr("in the obstacle"));
}

TEST_F(OutputVerification, what_holds_no_positions_is_refused) {
  EXPECT_THAT(refusal_of(check_verifiable(request("a.csv"))), HasSubstr("leave --verify out"));
  EXPECT_THAT(refusal_of(check_verifiable(request("a.rbn"))), HasSubstr("ribbon-play --verify"));
}

}  // namespace ribbon::output_verification_test
