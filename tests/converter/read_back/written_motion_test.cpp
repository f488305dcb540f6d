#include "converter/read_back/written_motion.h"

#include <gtest/gtest.h>

#include <new>
#include <system_error>

#include "result/refusal.h"

namespace ribbon::written_motion_test {

template <class Problem>
Result<bool> read_with(const Problem& problem) {
  return read_strictly("knot.glb", [&]() -> bool { throw problem; });
}

TEST(WrittenMotion, what_is_wrong_with_a_file_is_said_of_it) {
  EXPECT_THAT(refusal_of(read_with(Spoiled("it ends too early"))),
              HasSubstr("knot.glb: cannot be read back: it ends too early"));
  EXPECT_THAT(refusal_of(read_with(std::out_of_range("map::at"))), HasSubstr("knot.glb"));
}

TEST(WrittenMotion, what_the_system_lacks_is_not_said_of_the_file) {
  EXPECT_THROW((void)read_with(std::bad_alloc()), std::bad_alloc);
  const std::system_error no_thread(
      std::make_error_code(std::errc::resource_unavailable_try_again));
  EXPECT_THROW((void)read_with(no_thread), std::system_error);
}

}  // namespace ribbon::written_motion_test
