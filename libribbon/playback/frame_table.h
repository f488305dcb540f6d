// Where the frames of a recording lie, found by its index or by scanning.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "playback/random_access_file.h"
#include "playback/recording_reader.h"
#include "recording/frame_record.h"

namespace ribbon {

struct FrameEntry {
  std::uint64_t offset = 0;  // of the record
  std::uint64_t record_bytes = 0;
  std::uint32_t frames_since_key = 0;
  std::optional<FrameNumbers> numbers;  // nothing: the record is lost
  bool readable = false;                // so are all frames that it needs
};

struct FrameTable {
  std::vector<FrameEntry> frames;
  std::vector<Damage> damage;
  bool finished = false;
  RunEnding ending = RunEnding::unknown;  // of what was finished
};

// The table that the index gives; nothing where index or footer is missing or not whole. The
// frames themselves are not looked at.
std::optional<FrameTable> table_from_index(const RandomAccessFile& file, std::uint32_t recording_id,
                                           std::uint64_t frames_begin);

// The table of what is really there: reads and checks every record.
FrameTable table_from_scan(const RandomAccessFile& file, std::uint32_t recording_id,
                           std::uint64_t frames_begin);

// Reads and checks the record of one frame into `bytes`; nothing where it is not what the table
// says. The answer borrows from `bytes`.
std::optional<FrameRecord> read_frame_record(const RandomAccessFile& file, const FrameEntry& entry,
                                             std::uint32_t recording_id, std::uint32_t frame,
                                             std::string& bytes);

}  // namespace ribbon
