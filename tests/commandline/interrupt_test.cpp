#include "commandline/interrupt.h"

#include <gtest/gtest.h>

namespace ribbon::interrupt_test {

TEST(Interrupt, nothing_is_requested_at_first) {
  EXPECT_FALSE(Interrupt().requested());
}

TEST(Interrupt, the_first_signal_sets_the_flag_and_the_job_goes_on) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const Interrupt interrupt;
    ASSERT_EQ(std::raise(signal), 0);
    EXPECT_TRUE(interrupt.requested());
  }
}

TEST(InterruptDeathTest, the_second_signal_ends_the_process) {
  const auto raise_twice = [](int first, int second) {
    const Interrupt interrupt;
    std::raise(first);
    std::raise(second);
  };
  EXPECT_EXIT(raise_twice(SIGINT, SIGINT), testing::KilledBySignal(SIGINT), "");
  EXPECT_EXIT(raise_twice(SIGINT, SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

TEST(InterruptDeathTest, a_closed_terminal_may_be_told_twice) {
  const auto raise_hang_ups = [](int last) {
    const Interrupt interrupt;
    std::raise(SIGHUP);
    std::raise(SIGHUP);
    std::raise(last);
    std::_Exit(interrupt.requested() ? 7 : 0);
  };
  EXPECT_EXIT(raise_hang_ups(SIGHUP), testing::ExitedWithCode(7), "");
  EXPECT_EXIT(raise_hang_ups(SIGINT), testing::KilledBySignal(SIGINT), "");
}

TEST(InterruptDeathTest, afterwards_a_signal_ends_the_process_again) {
  const auto raise_after = [] {
    { const Interrupt interrupt; }
    std::raise(SIGINT);
  };
  EXPECT_EXIT(raise_after(), testing::KilledBySignal(SIGINT), "");
}

TEST(Interrupt, an_ignored_signal_stays_ignored) {
  const auto before = std::signal(SIGINT, SIG_IGN);
  const Interrupt interrupt;
  ASSERT_EQ(std::raise(SIGINT), 0);
  EXPECT_FALSE(interrupt.requested());
  EXPECT_EQ(std::signal(SIGINT, before), SIG_IGN);
}

TEST(Interrupt, an_ignored_signal_stays_ignored_when_another_has_come) {
  const auto before = std::signal(SIGINT, SIG_IGN);
  {
    const Interrupt interrupt;
    ASSERT_EQ(std::raise(SIGTERM), 0);
    EXPECT_TRUE(interrupt.requested());
    ASSERT_EQ(std::raise(SIGINT), 0);
  }
  EXPECT_EQ(std::signal(SIGINT, before), SIG_IGN);
}

}  // namespace ribbon::interrupt_test
