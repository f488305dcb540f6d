#include "recorder/page/tying.h"

#include <utility>

namespace ribbon {

Result<Tying> Tying::begin(const std::filesystem::path& scene,
                           const std::optional<TriangleMesh>& obstacle,
                           const std::filesystem::path& recording, const std::string& program) {
  const auto read = read_scene(scene);
  if (!read) return tl::unexpected(read.error());
  auto begun = begin_recording(obstacle, *read,
                               {.file = recording, .program = program, .overwrite = Overwrite::yes},
                               StartObserver());
  if (!begun) return tl::unexpected(begun.error());
  return Tying(*std::move(begun));
}

Tying::Tying(std::unique_ptr<BegunRun> begun)
    : begun_(std::move(begun)),
      run_(begun_->frames, begun_->plan, false, begun_->file, begun_->statistics) {}

Result<bool> Tying::next() {
  if (const auto numbers = run_.next(); !numbers) return tl::unexpected(numbers.error());
  const RunEnding ending = run_.ending();
  if (ending == RunEnding::unknown) return true;
  return finish(ending).map([] { return false; });
}

Result<void> Tying::stop() {
  return finish(RunEnding::stopped);
}

Result<void> Tying::finish(RunEnding ending) {
  const auto finished = run_.finish(ending);
  if (!finished) return tl::unexpected(finished.error());
  statistics_ = *finished;
  return {};
}

std::string Tying::summary() const {
  return summary_line(*statistics_);
}

}  // namespace ribbon
