#include "converter/export/pc2_writer.h"

#include <gtest/gtest.h>

#include "files/files.h"
#include "files/temporary_folder.h"
#include "result/refusal.h"

namespace ribbon::pc2_writer_test {

Model two_points() {
  Model model;
  model.objects.emplace_back().positions.resize(3, 2);
  model.objects.front().positions << 1, 4, 2, 5, 3, 6;
  return model;
}

TEST(Pc2Writer, the_bytes_are_as_the_format_says) {
  const auto path = temporary_file("pc2") / "a.pc2";
  Model model = two_points();
  const auto cache = new_pc2_writer(path, model, 2).value();
  ASSERT_TRUE(cache->append(model));
  model.objects.front().positions *= -1;
  ASSERT_TRUE(cache->append(model));
  EXPECT_FALSE(std::filesystem::exists(path)) << "the file must not appear before it is complete";
  ASSERT_TRUE(cache->finish());
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

TEST(Pc2Writer, an_unwritable_place_is_named) {
  EXPECT_THAT(refusal_of(new_pc2_writer("/dev/null/a.pc2", two_points(), 2)),
              HasSubstr("/dev/null"));
}

}  // namespace ribbon::pc2_writer_test
