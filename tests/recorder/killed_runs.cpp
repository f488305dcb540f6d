#include "recorder/killed_runs.h"

#include <chrono>
#include <random>
#include <thread>
#include <vector>

#include "playback/frames_of.h"
#include "recorder/process.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

class KilledRuns {
 public:
  KilledRuns(fs::path recorder, fs::path scene, const fs::path& folder, unsigned seed)
      : recorder_(std::move(recorder)),
        scene_(std::move(scene)),
        whole_(folder / "whole.rbn"),
        killed_(folder / "killed.rbn"),
        copy_(folder / "copy.rbn"),
        random_(seed) {}

  KillReport run(int kills) {
    record_whole();
    for (int kill = 0; kill < kills && report_.problem.empty(); ++kill) {
      kill_once(kill);
      if (report_.problem.empty()) look();
      if (!report_.problem.empty()) report_.problem += " (kill " + std::to_string(kill + 1) + ")";
    }
    return report_;
  }

 private:
  void record_whole() {
    const auto begin = Clock::now();
    if (waited_for(spawned(recording_into(whole_))) != 0)
      return blame("the scene cannot be recorded");
    duration_s_ = std::chrono::duration<double>(Clock::now() - begin).count();
    frames_ = frames_of(whole_);
  }

  [[nodiscard]] std::vector<std::string> recording_into(const fs::path& target) const {
    return {recorder_, scene_, "--force", "-o", target, "--quiet"};
  }
  [[nodiscard]] std::vector<std::string> resuming(const fs::path& target) const {
    return {recorder_, "--resume", target, "--quiet"};
  }

  void kill_once(int number) {
    const bool anew = number % 3 == 0 || !can_go_on_;
    if (anew) fs::remove(killed_);
    last_was_resumed_ = !anew;
    const pid_t process = spawned(anew ? recording_into(killed_) : resuming(killed_));
    const double waited_s =
        std::uniform_real_distribution(0.0, (anew ? 1.0 : 0.6) * duration_s_)(random_);
    std::this_thread::sleep_for(std::chrono::duration<double>(waited_s));
    ::kill(process, SIGKILL);
    const int exit_code = waited_for(process);
    if (exit_code > 0) return blame("the recorder fails with " + std::to_string(exit_code));
    ++report_.kills;
    if (!anew) ++report_.of_resumed_runs;
    if (exit_code != 0) return;
    ++report_.came_to_their_end;
    // It was less: the machine was slower at first. Most of what comes is to be killed.
    if (anew) duration_s_ = waited_s / 2;
  }

  void look() {
    auto reader = RecordingReader::open(killed_);
    can_go_on_ = reader.has_value();
    if (!reader) {
      ++report_.before_the_header;
      if (last_was_resumed_) blame("what a kill left cannot be read");
      return;
    }
    reader->check();
    if (!reader->damage().empty()) return blame("a kill left damage");
    const auto played = frames_of(*reader);
    if (played.empty()) ++report_.without_frames;
    report_.frames_played += static_cast<long>(played.size());
    compare(played, "as killed");
    if (reader->finished()) can_go_on_ = false;
    if (report_.problem.empty()) resume_copy();
  }

  void resume_copy() {
    fs::copy_file(killed_, copy_, fs::copy_options::overwrite_existing);
    if (waited_for(spawned(resuming(copy_))) != 0) return blame("the run cannot be resumed");
    auto reader = RecordingReader::open(copy_);
    if (!reader || !reader->finished()) return blame("the resumed run did not come to its end");
    reader->check();
    if (!reader->damage().empty()) return blame("the resumed recording is damaged");
    const auto played = frames_of(*reader);
    report_.frames_resumed += static_cast<long>(played.size());
    if (played.size() != frames_.size())
      return blame("the resumed run has " + std::to_string(played.size()) + " frames");
    compare(played, "resumed");
  }

  void compare(const std::vector<PlayedFrame>& played, const std::string& how) {
    if (const int frame = first_difference(played, frames_); frame >= 0)
      blame("frame " + std::to_string(frame + 1) + ", " + how + ", is another one");
  }

  void blame(const std::string& problem) { report_.problem = problem; }

  fs::path recorder_;
  fs::path scene_;
  fs::path whole_;
  fs::path killed_;
  fs::path copy_;
  std::mt19937 random_;
  double duration_s_ = 0;
  std::vector<PlayedFrame> frames_;
  bool can_go_on_ = false;
  bool last_was_resumed_ = false;
  KillReport report_;
};

}  // namespace

KillReport kill_and_resume(const fs::path& recorder, const fs::path& scene, const fs::path& folder,
                           int kills, unsigned seed) {
  return KilledRuns(recorder, scene, folder, seed).run(kills);
}

}  // namespace ribbon
