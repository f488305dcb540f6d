#include "player/output/background_sink.h"

#include <gtest/gtest.h>

#include <memory>
#include <new>
#include <thread>
#include <vector>

#include "result/refusal.h"

namespace ribbon::background_sink_test {

// Notes what it gets; refuses one number, and has no memory for the number 0.
class NotingSink final : public PictureSink {
 public:
  NotingSink(std::vector<int>& numbers, int refused) : numbers_(numbers), refused_(refused) {}
  Result<void> put(OutputPicture picture) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (picture.number == 0) throw std::bad_alloc();
    if (picture.number == refused_) return failure("picture", "is refused", "take another one");
    numbers_.push_back(picture.number);
    return {};
  }
  Result<void> finish() override {
    numbers_.push_back(-1);
    return {};
  }

 private:
  std::vector<int>& numbers_;
  int refused_;
};

TEST(BackgroundSink, keeps_the_order_and_finishes_after_the_last) {
  std::vector<int> numbers;
  BackgroundSink sink(std::make_unique<NotingSink>(numbers, 0));
  for (int number = 1; number <= 9; ++number) ASSERT_TRUE(sink.put({.number = number}));
  ASSERT_TRUE(sink.finish());
  EXPECT_EQ(numbers, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8, 9, -1}));
}

TEST(BackgroundSink, tells_the_first_problem_and_writes_nothing_after_it) {
  std::vector<int> numbers;
  BackgroundSink sink(std::make_unique<NotingSink>(numbers, 3));
  Result<void> put;
  int number = 1;
  while (put && number < 100) put = sink.put({.number = number++});
  EXPECT_THAT(refusal_of(put), HasSubstr("is refused"));
  EXPECT_LT(number, 10);
  EXPECT_THAT(refusal_of(sink.finish()), HasSubstr("is refused"));
  EXPECT_EQ(numbers, (std::vector<int>{1, 2}));
}

TEST(BackgroundSink, a_lack_of_memory_is_a_problem_like_any_other) {
  std::vector<int> numbers;
  BackgroundSink sink(std::make_unique<NotingSink>(numbers, 9));
  ASSERT_TRUE(sink.put({.number = 0}));
  EXPECT_THAT(refusal_of(sink.finish()), HasSubstr("not enough memory"));
  EXPECT_EQ(numbers, std::vector<int>());
}

TEST(BackgroundSink, given_up_writes_what_was_put_but_does_not_finish) {
  std::vector<int> numbers;
  {
    BackgroundSink sink(std::make_unique<NotingSink>(numbers, 0));
    ASSERT_TRUE(sink.put({.number = 1}));
    ASSERT_TRUE(sink.put({.number = 2}));
  }
  EXPECT_EQ(numbers, (std::vector<int>{1, 2}));
}

}  // namespace ribbon::background_sink_test
