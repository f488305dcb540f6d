#include "converter/export/point_cache.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "result/refusal.h"

namespace ribbon::point_cache_test {

std::filesystem::path empty_folder(const std::string& name) {
  auto folder = std::filesystem::path(testing::TempDir()) / name;
  std::filesystem::remove_all(folder);
  return folder;
}

TEST(PointCache, the_bytes_are_as_the_format_says) {
  const auto path = empty_folder("point_cache") / "a.pc2";
  auto cache = PointCacheWriter::create(path, 2, 2).value();
  Eigen::Matrix3Xf sample(3, 2);
  sample << 1, 4, 2, 5, 3, 6;
  ASSERT_TRUE(cache.append(sample));
  ASSERT_TRUE(cache.append(-sample));
  EXPECT_FALSE(std::filesystem::exists(path)) << "the file must not appear before it is complete";
  ASSERT_TRUE(cache.finish());
  const std::string bytes = read_file(path).value();
  ASSERT_EQ(bytes.size(), 32U + 2 * 2 * 12);
  // "POINTCACHE2\0", 1, 2 points, start 0, sampling 1.0, 2 samples.
  EXPECT_EQ(bytes.substr(0, 32), std::string("POINTCACHE2\0\1\0\0\0\2\0\0\0\0\0\0\0\0\0\x80\x3f"
                                             "\2\0\0\0",
                                             32));
  std::array<float, 12> numbers{};
  std::memcpy(numbers.data(), bytes.data() + 32, 48);
  EXPECT_EQ(numbers, (std::array<float, 12>{1, 2, 3, 4, 5, 6, -1, -2, -3, -4, -5, -6}));
}

TEST(PointCache, an_unfinished_cache_leaves_nothing_behind) {
  const auto folder = empty_folder("unfinished_cache");
  {
    auto cache = PointCacheWriter::create(folder / "a.pc2", 2, 2).value();
    ASSERT_TRUE(cache.append(Eigen::Matrix3Xf::Zero(3, 2)));
    EXPECT_FALSE(std::filesystem::is_empty(folder));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(PointCache, an_unwritable_place_is_named) {
  EXPECT_THAT(refusal_of(PointCacheWriter::create("/dev/null/a.pc2", 2, 2)),
              HasSubstr("/dev/null"));
}

}  // namespace ribbon::point_cache_test
