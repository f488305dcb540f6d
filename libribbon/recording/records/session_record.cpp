#include "recording/records/session_record.h"

#include "recording/coding/bytes.h"

namespace ribbon {

std::string session_payload(std::uint32_t recording_id, const Session& session) {
  std::string bytes;
  put<std::uint32_t>(bytes, recording_id);
  put<std::uint32_t>(bytes, session.first_frame);
  put<std::uint8_t>(bytes, static_cast<std::uint8_t>(session.note.reason));
  put_string(bytes, session.note.program);
  put_string(bytes, session.note.changed_settings);
  return bytes;
}

std::optional<Session> parse_session_payload(std::string_view payload, std::uint32_t recording_id) {
  ByteTaker taker(payload);
  Session session;
  const auto id = taker.take<std::uint32_t>();
  session.first_frame = taker.take<std::uint32_t>();
  const auto reason = taker.take<std::uint8_t>();
  // Reasons that this version does not know are as good as none.
  if (reason <= static_cast<std::uint8_t>(SessionReason::begun))
    session.note.reason = static_cast<SessionReason>(reason);
  session.note.program = take_string(taker);
  session.note.changed_settings = take_string(taker);
  if (!taker.complete() || id != recording_id) return std::nullopt;
  return session;
}

}  // namespace ribbon
