// Whatever the bytes of a file, the reader tells what is there and never falls over it.
#include <Eigen/Core>
#include <map>
#include <span>
#include <string>

#include "continuation/resume_recording.h"
#include "fuzz/memory_file.h"
#include "fuzz/must.h"
#include "fuzz/repaired_checksums.h"
#include "playback/recording_reader.h"

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace ribbon {
namespace {

using Frames = std::map<int, Eigen::Matrix3Xf>;

// Every frame that can be read, the last first.
Frames frames_of(RecordingReader& reader) {
  Frames frames;
  Eigen::Matrix3Xf positions;
  for (int i = reader.frame_count() - 1; i >= 0; --i) {
    const bool promised = reader.readable(i) && reader.numbers(i).has_value();
    const auto read = reader.read(i, positions);
    must(promised || !read, "what is not readable is not read");
    if (!read) continue;
    must(positions.cols() == reader.header().grid.particle_count(), "frames have all particles");
    frames[i] = positions;
  }
  return frames;
}

void must_agree(const Frames& some, const Frames& others) {
  for (const auto& [number, positions] : some)
    if (const auto other = others.find(number); other != others.end())
      must(same_bits(positions, other->second), "a frame is the same however it was come by");
}

// Whatever else it holds can be asked for.
void read_the_rest(const RecordingReader& reader) {
  for (const std::uint32_t frame : reader.checkpoints())
    if (const auto checkpoint = reader.read_checkpoint(frame))
      must(checkpoint->frame == frame, "a checkpoint is that of its frame");
  must(reader.sessions().size() <= reader.file_bytes(), "sessions take bytes");
}

Frames frames_of_checked(const std::string& path) {
  auto reader = RecordingReader::open(path);
  must(reader.has_value(), "a file that opened once opens again");
  reader->check();
  return frames_of(*reader);
}

// Read first when only a part of the file is there, which part its last byte says, and again when
// it is whole.
Frames frames_while_growing(std::span<const std::uint8_t> data) {
  const std::size_t first = data.size() * data.back() / 256;
  const MemoryFile file("recording");
  file.append(data.data(), first);
  auto reader = RecordingReader::open(file.path());
  if (!reader) return {};
  const Frames early = frames_of(*reader);
  file.append(data.data() + first, data.size() - first);
  must(reader->refresh().has_value(), "a file that has grown is read on");
  Frames late = frames_of(*reader);
  must_agree(early, late);
  return late;
}

// One more frame is appended; all that could be read before must still be there.
void check_resuming(std::span<const std::uint8_t> data, const RibbonGrid& grid,
                    const Frames& before) {
  constexpr int most_particles = 1000;
  if (grid.particle_count() > most_particles) return;
  const MemoryFile file("recording");
  file.append(data.data(), data.size());
  auto writer = resume_recording(file.path());
  if (!writer) return;
  const auto next = static_cast<int>(writer->frames_written());
  const auto appended = writer->append({}, Eigen::Matrix3Xd::Zero(3, grid.particle_count()));
  must(appended.has_value(), "a frame of zeros can be appended");
  must(writer->finish().has_value(), "a resumed recording can be finished");
  auto reader = RecordingReader::open(file.path());
  must(reader.has_value(), "a resumed recording opens");
  const Frames after = frames_of(*reader);
  for (const auto& [number, positions] : before)
    must(after.contains(number), "resuming loses no frame");
  must_agree(before, after);
  must(after.contains(next), "a resumed recording has the frame that was appended");
}

}  // namespace
}  // namespace ribbon

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, max_size);
  // One in eight keeps what is wrong with it.
  if (seed % 8 != 0) ribbon::repair_checksums({data, mutated});
  return mutated;
}

// libFuzzer gives the name. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ribbon;
  const MemoryFile file("recording");
  file.append(data, size);
  auto reader = RecordingReader::open(file.path());
  if (!reader) return 0;
  const Frames frames = frames_of(*reader);
  read_the_rest(*reader);
  must_agree(frames, frames_of_checked(file.path()));
  must_agree(frames, frames_while_growing({data, size}));
  check_resuming({data, size}, reader->header().grid, frames);
  return 0;
}
