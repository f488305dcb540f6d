// verify_with_cgal RECORDING...: looks at every frame with ribbon's verification and with CGAL, and
// prints what they do not agree on, what intersects, and how long each takes. Exit code 1 when they
// disagree about anything or a frame cannot be read.
#include <chrono>
#include <cstdio>
#include <vector>

#include "playback/recording_reader.h"
#include "verification/cgal_oracle.h"
#include "verification/frame_verifier.h"

namespace ribbon {
namespace {

struct Tally {
  int frames = 0;
  int intersecting_frames = 0;
  std::size_t pairs = 0;
  int disagreements = 0;
  int lost = 0;
  double own_s = 0;
  double cgal_s = 0;
};

// Runs `function` and adds the time that it takes.
template <class Function>
auto timed(double& seconds, const Function& function) {
  const auto start = std::chrono::steady_clock::now();
  auto result = function();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

std::vector<TrianglePair> within_ribbon(const TriangleSoup& soup,
                                        const std::vector<TrianglePair>& pairs) {
  std::vector<TrianglePair> result;
  for (const TrianglePair& pair : pairs)
    if (pair.second < soup.judged) result.push_back(pair);
  return result;
}

void disagree(Tally& tally, const char* file, int frame, const char* with, std::size_t own,
              std::size_t theirs) {
  ++tally.disagreements;
  std::printf("%s: frame %d: verification finds %zu pairs, %s %zu, not the same\n", file, frame,
              own, with, theirs);
}

void compare(const char* file, int frame, const RibbonGrid& grid, const FrameVerifier& verifier,
             const Eigen::Matrix3Xf& positions, Tally& tally) {
  const FrameVerdict verdict = timed(tally.own_s, [&] { return verifier.verify(positions); });
  const std::vector<TrianglePair>& own = verdict.intersections.pairs;
  ++tally.frames;
  tally.pairs += own.size();
  if (!own.empty()) ++tally.intersecting_frames;
  if (!verdict.finite || !verdict.intersections.all) {
    disagree(tally, file, frame, "which it cannot judge; CGAL", own.size(), 0);
    return;
  }
  const TriangleSoup soup = verifier.soup(positions);
  const auto theirs = timed(tally.cgal_s, [&] { return cgal_intersecting_pairs(soup); });
  if (own != theirs) disagree(tally, file, frame, "CGAL's kernel", own.size(), theirs.size());
  const auto meshed = cgal_self_intersections(grid, positions);
  const auto own_ribbon = within_ribbon(soup, own);
  if (meshed && own_ribbon != *meshed)
    disagree(tally, file, frame, "CGAL's mesh test", own_ribbon.size(), meshed->size());
}

// False when the recording cannot be opened.
bool compare_all(const char* file, Tally& tally) {
  auto reader = RecordingReader::open(file);
  if (!reader) {
    std::printf("%s\n", reader.error().sentence().c_str());
    return false;
  }
  const RecordingHeader& header = reader->header();
  const FrameVerifier verifier(rest_size(header), header.obstacle);
  Eigen::Matrix3Xf positions;
  for (int index = 0; index < reader->frame_count(); ++index) {
    if (reader->read(index, positions))
      compare(file, index + 1, header.grid, verifier, positions, tally);
    else
      ++tally.lost;
  }
  return true;
}

// True when both agree on the whole recording.
bool report(const char* file) {
  Tally tally;
  if (!compare_all(file, tally)) return false;
  const double frames = tally.frames > 0 ? tally.frames : 1;
  std::printf(
      "%s: %d frames, %d lost, %zu intersecting pairs in %d frames, %d disagreements, %.1f ms a "
      "frame, CGAL %.1f ms\n",
      file, tally.frames, tally.lost, tally.pairs, tally.intersecting_frames, tally.disagreements,
      1000 * tally.own_s / frames, 1000 * tally.cgal_s / frames);
  return tally.disagreements == 0 && tally.lost == 0;
}

}  // namespace
}  // namespace ribbon

int main(int argc, char** argv) {
  bool agreed = argc > 1;
  for (int k = 1; k < argc; ++k) agreed = ribbon::report(argv[k]) && agreed;
  return agreed ? 0 : 1;
}
