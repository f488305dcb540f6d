// What holds of every format that has a whole motion in one file.
#include "model/motion_writer.h"

#include <gtest/gtest.h>

#include "converter/motion_format.h"
#include "files/files.h"
#include "files/temporary_folder.h"
#include "recording/size_limit.h"
#include "result/demanded.h"
#include "result/refusal.h"

namespace ribbon {

std::ostream& operator<<(std::ostream& stream, const MotionFormat& format) {
  return stream << format.extension;
}

}  // namespace ribbon

namespace ribbon::motion_writer_test {

// Two objects of two triangles, whose names need care in some formats.
Model two_squares() {
  Model model;
  model.frames_per_second = 29.97;
  model.grid = {.along = 2, .across = 2};
  for (const char* name : {"a/\"knot\" 1", "a_\"knot\" 1"}) {
    ModelObject& object = model.objects.emplace_back();
    object.name = name;
    object.material = {"Materials", Eigen::Vector3f(0.5F, 0.25F, 0)};
    object.positions = Eigen::Matrix3Xf(3, 4);
    object.positions << 0, 1, 1, 0, 0, 0, 1, 1, 0.5F, 0, 0.5F, 0;
    object.uv = object.positions.topRows(2);
    object.faces = Eigen::MatrixXi(3, 2);
    object.faces << 0, 0, 1, 2, 2, 3;
  }
  return model;
}

std::string written(const MotionFormat& format, const std::filesystem::path& path, int frames) {
  Model model = two_squares();
  const auto writer = demanded(format.new_writer(path, model, frames));
  for (int frame = 0; frame < frames; ++frame) {
    model.objects.front().positions.array() += 0.25F;
    demanded(writer->append(model));
  }
  demanded(writer->finish());
  return demanded(read_file(path));
}

class EveryMotionFormat : public TestInFolder, public testing::WithParamInterface<MotionFormat> {
 protected:
  std::filesystem::path path_ = folder_ / ("knot" + std::string(GetParam().extension));
};

TEST_P(EveryMotionFormat, the_same_motion_gives_the_same_bytes) {
  EXPECT_TRUE(written(GetParam(), path_, 3) == written(GetParam(), path_, 3));
}

TEST_P(EveryMotionFormat, one_frame_is_enough) {
  EXPECT_GT(written(GetParam(), path_, 1).size(), 48U);
}

TEST_P(EveryMotionFormat, what_is_not_finished_leaves_nothing_behind) {
  {
    const auto writer = demanded(GetParam().new_writer(path_, two_squares(), 2));
    demanded(writer->append(two_squares()));
    EXPECT_FALSE(std::filesystem::exists(path_)) << "it must not appear before it is complete";
  }
  EXPECT_TRUE(std::filesystem::is_empty(path_.parent_path()));
}

TEST_P(EveryMotionFormat, a_disk_that_fills_up_is_told_and_leaves_nothing_behind) {
  const SizeLimit limit(100);
  {
    Result<void> answer;
    const auto writer = demanded(GetParam().new_writer(path_, two_squares(), 3));
    for (int frame = 0; answer && frame < 3; ++frame) answer = writer->append(two_squares());
    if (answer) answer = writer->finish();
    EXPECT_THAT(refusal_of(answer), HasSubstr("cannot be written"));
  }
  EXPECT_TRUE(std::filesystem::is_empty(path_.parent_path()));
}

TEST_P(EveryMotionFormat, an_unwritable_place_is_named) {
  const auto file = "/dev/null/knot" + std::string(GetParam().extension);
  EXPECT_THAT(refusal_of(GetParam().new_writer(file, two_squares(), 2)), HasSubstr("/dev/null"));
}

INSTANTIATE_TEST_SUITE_P(Motion, EveryMotionFormat,
                         testing::ValuesIn(motion_formats().begin(), motion_formats().end()),
                         [](const auto& parameter) {
                           return std::string(parameter.param.extension.substr(1));
                         });

}  // namespace ribbon::motion_writer_test
