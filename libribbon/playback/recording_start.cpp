#include "playback/recording_start.h"

#include <string>
#include <utility>

#include "recording/coding/checksum.h"
#include "recording/records/header_record.h"
#include "recording/records/record_head.h"

namespace ribbon {

namespace {

Result<RecordingStart> read_start(const RandomAccessFile& file, const std::filesystem::path& path) {
  const std::string signature = file.read(0, file_signature.size());
  const bool signed_file = signature == file_signature;
  const auto head = parse_record_head(file.read(file_signature.size(), record_head_bytes));
  const std::uint64_t payload_offset = file_signature.size() + record_head_bytes;
  const std::uint64_t first_frame_offset = payload_offset + (head ? head->payload_bytes : 0);
  if (file_signature.starts_with(signature) && file.size() < first_frame_offset)
    return failure(
        path.string(),
        "ends before its first frame: its recorder was stopped at once, or the rest is lost",
        "record it again with --force, or use a copy that is whole");
  if (!signed_file && !head)
    return failure(path.string(), "is not a ribbon recording", "name a file by ribbon-record");
  const bool may_be_read = head && head->payload_bytes <= most_header_bytes;
  const std::string payload =
      may_be_read ? file.read(payload_offset, head->payload_bytes) : std::string();
  if (!head || head->type != RecordType::header || payload.size() != head->payload_bytes ||
      checksum(payload) != head->payload_checksum)
    return failure(path.string(), "the header is damaged",
                   "use a copy of the recording that is whole");
  auto header = parse_header_payload(payload);
  if (!header) {
    header.error().place = path.string();
    return tl::unexpected(std::move(header.error()));
  }
  return RecordingStart{std::move(*header), head->payload_checksum,
                        payload_offset + head->payload_bytes, signed_file};
}

}  // namespace

Result<OpenedRecording> open_recording(const std::filesystem::path& path) {
  auto file = RandomAccessFile::open(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  auto start = read_start(*file, path);
  if (!start) return tl::unexpected(std::move(start.error()));
  return OpenedRecording{*std::move(file), *std::move(start)};
}

}  // namespace ribbon
