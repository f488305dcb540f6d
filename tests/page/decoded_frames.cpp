// decoded_frames RECORDING: prints a hash of the positions of every frame, as they are decoded,
// first from the last frame to the first and then in order.
#include <cstdint>
#include <cstdio>

#include "commandline/tool.h"
#include "playback/recording_reader.h"

namespace ribbon {

namespace {

// FNV-1a, of 32 bits at a time.
std::uint64_t hash_of(const Eigen::Matrix3Xf& positions) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const float value : positions.reshaped())
    hash = (hash ^ Eigen::numext::bit_cast<std::uint32_t>(value)) * 0x100000001b3;
  return hash;
}

Result<void> print_frame(RecordingReader& reader, int index) {
  Eigen::Matrix3Xf positions;
  if (auto read = reader.read(index, positions); !read) return read;
  std::printf("%d %016llx\n", index + 1, static_cast<unsigned long long>(hash_of(positions)));
  return {};
}

Result<ExitCode> print_frames(const char* file) {
  auto reader = RecordingReader::open(file);
  if (!reader) return tl::unexpected(reader.error());
  const int count = reader->frame_count();
  for (int call = 0; call < 2 * count; ++call) {
    const int index = call < count ? count - 1 - call : call - count;
    if (auto printed = print_frame(*reader, index); !printed)
      return tl::unexpected(printed.error());
  }
  return ExitCode::done;
}

}  // namespace

}  // namespace ribbon

int main(int argc, char** argv) {
  return ribbon::run_tool("decoded_frames", [&]() -> ribbon::Result<ribbon::ExitCode> {
    if (argc != 2) return ribbon::failure("", "needs a name", "decoded_frames RECORDING");
    return ribbon::print_frames(argv[1]);
  });
}
