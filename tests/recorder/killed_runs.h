// Recordings whose recorder was killed, played and taken up again.
#pragma once

#include <filesystem>
#include <string>

namespace ribbon {

struct KillReport {
  int kills = 0;
  int before_the_header = 0;  // kills that left no recording to go on with
  int of_resumed_runs = 0;    // kills of runs that had been killed before
  int came_to_their_end = 0;  // runs that ended before they were to be killed
  int without_frames = 0;     // kills that left a header alone
  long frames_played = 0;     // of killed recordings, compared with the uninterrupted one
  long frames_resumed = 0;    // of those taken up again and brought to their end, compared likewise
  std::string problem;        // the first thing that was not as it should be
};

// Records `scene` with `recorder` once without interruption, then `kills` times with SIGKILL after
// a time that differs each time (by `seed`): every third run from its beginning, the others by
// --resume of what the last kill left. After each kill the recording is played, and a copy of it is
// brought to its end by --resume: every frame must be the uninterrupted one, bit for bit. Works in
// `folder`, which should be the scene's own. Ends with the first problem.
KillReport kill_and_resume(const std::filesystem::path& recorder,
                           const std::filesystem::path& scene, const std::filesystem::path& folder,
                           int kills, unsigned seed);

}  // namespace ribbon
