#include "recording/records/checkpoint_record.h"

#include <cstddef>

#include "recording/coding/bytes.h"
#include "recording/coding/checksum.h"
#include "recording/coding/compression.h"

namespace ribbon {

namespace {

constexpr std::size_t fields_bytes = 32;

}  // namespace

std::uint64_t largest_state_bytes(const RibbonGrid& grid) {
  return std::uint64_t{4096} * static_cast<std::uint64_t>(grid.particle_count()) + (1U << 20);
}

std::string checkpoint_payload(std::uint32_t recording_id, std::uint32_t frame, std::uint64_t steps,
                               std::string_view state) {
  std::string bytes;
  put<std::uint32_t>(bytes, recording_id);
  put<std::uint32_t>(bytes, frame);
  put<std::uint64_t>(bytes, steps);
  put<std::uint64_t>(bytes, state.size());
  put<std::uint32_t>(bytes, checksum(state));
  put<std::uint32_t>(bytes, fields_bytes);
  bytes += Compressor().compress(state);
  return bytes;
}

std::optional<CheckpointFields> parse_checkpoint_fields(std::string_view payload) {
  ByteTaker taker(payload);
  CheckpointFields fields;
  fields.recording_id = taker.take<std::uint32_t>();
  fields.frame = taker.take<std::uint32_t>();
  fields.steps = taker.take<std::uint64_t>();
  fields.state_bytes = taker.take<std::uint64_t>();
  fields.state_checksum = taker.take<std::uint32_t>();
  fields.state_at = taker.take<std::uint32_t>();
  if (!taker.complete() || fields.state_at < fields_bytes || fields.state_at > payload.size())
    return std::nullopt;
  return fields;
}

std::optional<Checkpoint> parse_checkpoint_payload(std::string_view payload,
                                                   std::uint32_t recording_id,
                                                   const RibbonGrid& grid) {
  const auto fields = parse_checkpoint_fields(payload);
  if (!fields || fields->recording_id != recording_id ||
      fields->state_bytes > largest_state_bytes(grid))
    return std::nullopt;
  Decompressor decompressor;
  const auto state = decompressor.decompress(payload.substr(fields->state_at),
                                             static_cast<std::size_t>(fields->state_bytes));
  if (!state || state->size() != fields->state_bytes || checksum(*state) != fields->state_checksum)
    return std::nullopt;
  return Checkpoint{fields->frame, fields->steps, std::string(*state)};
}

}  // namespace ribbon
