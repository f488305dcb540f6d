#include "recording/records/session_record.h"

#include <gtest/gtest.h>

namespace ribbon::session_record_test {

constexpr std::uint32_t id = 0x1234;
const Session session{300, {SessionReason::extended, "ribbon-record 1.0", "time.step = 1\n"}};

TEST(SessionRecord, everything_comes_back) {
  EXPECT_EQ(parse_session_payload(session_payload(id, session), id), session);
}

TEST(SessionRecord, every_reason_comes_back) {
  for (int number = 0; number <= 3; ++number) {
    Session with = session;
    with.note.reason = static_cast<SessionReason>(number);
    EXPECT_EQ(parse_session_payload(session_payload(id, with), id), with);
  }
}

TEST(SessionRecord, a_reason_of_a_later_version_is_none) {
  std::string payload = session_payload(id, session);
  payload[8] = 17;
  EXPECT_EQ(parse_session_payload(payload, id)->note.reason, SessionReason::unknown);
}

TEST(SessionRecord, one_of_another_recording_is_refused) {
  EXPECT_FALSE(parse_session_payload(session_payload(id, session), id + 1).has_value());
}

TEST(SessionRecord, every_prefix_is_refused) {
  const std::string payload = session_payload(id, session);
  for (std::size_t size = 0; size < payload.size(); ++size)
    EXPECT_FALSE(parse_session_payload(payload.substr(0, size), id).has_value()) << size;
}

}  // namespace ribbon::session_record_test
