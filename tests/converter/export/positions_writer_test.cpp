// The formats that are a header and then positions.
#include "converter/export/positions_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "converter/export/mdd_writer.h"
#include "converter/export/npy_writer.h"
#include "converter/export/pc2_writer.h"
#include "files/files.h"
#include "files/temporary_folder.h"
#include "result/refusal.h"

namespace ribbon::positions_writer_test {

using namespace std::string_literals;

Model two_points() {
  Model model;
  model.frames_per_second = 4;
  model.grid = {.along = 1, .across = 2};
  model.objects.emplace_back().positions.resize(3, 2);
  model.objects.front().positions << 1, 4, 2, 5, 3, 6;
  return model;
}

// The file of two points, which are mirrored in the second frame.
template <class NewWriter>
std::string two_frames(const char* name, NewWriter new_writer) {
  const auto path = temporary_file(name);
  Model model = two_points();
  const auto writer = new_writer(path, model, 2).value();
  EXPECT_TRUE(writer->append(model));
  model.objects.front().positions *= -1;
  EXPECT_TRUE(writer->append(model));
  EXPECT_TRUE(writer->finish());
  return read_file(path).value();
}

std::array<float, 12> floats_of(const std::string& bytes) {
  EXPECT_EQ(bytes.size(), 48U);
  std::array<float, 12> numbers{};
  std::memcpy(numbers.data(), bytes.data(), std::min<std::size_t>(bytes.size(), 48));
  return numbers;
}

constexpr std::array<float, 12> expected{1, 2, 3, 4, 5, 6, -1, -2, -3, -4, -5, -6};

TEST(Pc2Writer, the_bytes_are_as_the_format_says) {
  const std::string bytes = two_frames("a.pc2", new_pc2_writer);
  // "POINTCACHE2\0", 1, 2 points, start 0, sampling 1.0, 2 samples.
  EXPECT_EQ(bytes.substr(0, 32), "POINTCACHE2\0\1\0\0\0\2\0\0\0\0\0\0\0\0\0\x80\x3f\2\0\0\0"s);
  EXPECT_EQ(floats_of(bytes.substr(32)), expected);
}

TEST(MddWriter, the_bytes_are_as_the_format_says) {
  std::string bytes = two_frames("a.mdd", new_mdd_writer);
  // 2 frames, 2 points, at 0 s and 0.25 s.
  EXPECT_EQ(bytes.substr(0, 16), "\0\0\0\2\0\0\0\2\0\0\0\0\x3e\x80\0\0"s);
  for (std::size_t i = 16; i + 4 <= bytes.size(); i += 4)
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(i),
                 bytes.begin() + static_cast<std::ptrdiff_t>(i + 4));
  EXPECT_EQ(floats_of(bytes.substr(16)), expected);
}

TEST(NpyWriter, the_bytes_are_as_the_format_says) {
  const std::string bytes = two_frames("a.npy", new_npy_writer);
  const std::string dictionary =
      "{'descr': '<f4', 'fortran_order': False, 'shape': (2, 1, 2, 3), }";
  EXPECT_EQ(bytes.substr(0, 128),
            "\x93NUMPY\1\0\x76\0"s + dictionary + std::string(117 - dictionary.size(), ' ') + '\n');
  EXPECT_EQ(floats_of(bytes.substr(128)), expected);
}

TEST(NpyWriter, a_ribbon_that_is_no_grid_is_refused) {
  Model model = two_points();
  model.grid.across = 3;
  EXPECT_THAT(refusal_of(new_npy_writer(temporary_file("b.npy"), model, 2)),
              HasSubstr("leave --thickness out"));
}

}  // namespace ribbon::positions_writer_test
