// A run that can be looked at, and ended, between any two frames.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "geometry/triangle_mesh.h"
#include "recorder/run/record_around.h"
#include "recorder/run/run.h"
#include "result/result.h"
#include "scene/scene.h"

namespace ribbon {

// Records what ribbon-record does of the same scene, to the same bytes.
class Tying {
 public:
  // Finds the start and creates the recording, or replaces an older one. program: as ribbon-record
  // names itself. Fails as begin_recording() does.
  static Result<Tying> begin(const std::filesystem::path& scene,
                             const std::optional<TriangleMesh>& obstacle,
                             const std::filesystem::path& recording, const std::string& program);

  // How many frames the recording will hold at most.
  [[nodiscard]] int most_frames() const { return begun_->plan.frames; }

  // Records one frame more. True as long as there is another one to come; afterwards the recording
  // is finished.
  Result<bool> next();
  // Finishes the recording early.
  Result<void> stop();
  // The figures of a finished run in one sentence.
  [[nodiscard]] std::string summary() const;

 private:
  explicit Tying(std::unique_ptr<BegunRun> begun);
  Result<void> finish(RunEnding ending);

  std::unique_ptr<BegunRun> begun_;
  Run run_;
  std::optional<RunStatistics> statistics_;  // of a finished run
};

}  // namespace ribbon
