#include "recorder/record.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "curve/space_curve.h"
#include "obstacle/obstacle.h"
#include "recorder/tying.h"
#include "recording/recording_writer.h"
#include "ribbon_mesh/ribbon_mesh.h"
#include "simulation/fastening_processor.h"

namespace ribbon {

namespace {

class Stopwatch {
 public:
  // Seconds since the last lap.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> elapsed = now - last_;
    last_ = now;
    return elapsed.count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::optional<CentreAxis> centre_axis(const Scene& scene) {
  if (!scene.fastening) return std::nullopt;
  return CentreAxis{scene.fastening->axis_point_m, scene.fastening->axis_direction};
}

RecordingHeader header_of(const Scene& scene, const std::string& writer, const RibbonMesh& ribbon,
                          const std::optional<TriangleMesh>& obstacle,
                          const FasteningProcessor& fastening) {
  RecordingHeader header;
  header.scene_name = scene.name;
  header.scene_text = scene.text;
  header.writer = writer;
  header.grid = ribbon.grid;
  header.uv = ribbon.uv;
  header.ribbon_length_m = ribbon.length_m;
  header.ribbon_width_m = ribbon.width_m;
  header.frames_per_second = scene.recording.frames_per_second;
  header.max_position_error_m = scene.recording.max_position_error_m(ribbon.length_m);
  // From any point of the start the ribbon can be drawn at most its length away.
  header.lattice_step_m = lattice_step_m(
      header.max_position_error_m, fastening.positions().cwiseAbs().maxCoeff() + ribbon.length_m);
  header.obstacle = obstacle;
  header.stated_gap_m = fastening.guaranteed_gap_m();
  header.centre_axis = centre_axis(scene);
  return header;
}

// The gate can grow a ribbon into less room than it needs at its crossings.
Result<SpaceCurve> centre_line(const Scene& scene) {
  return generate_space_curve(
      scene.curve, scene.ribbon.width_m, scene.ribbon.along,
      scene.contact == ContactMethod::gate ? TightPassage::squeeze : TightPassage::refuse);
}

// A start without room is told with the tightest passage of the drawing, if that was squeezed.
Error with_tight_passage(const Scene& scene, Error error) {
  const auto roomy = generate_space_curve(scene.curve, scene.ribbon.width_m, scene.ribbon.along);
  if (!roomy) error.problem += " (" + roomy.error().place + ": " + roomy.error().problem + ")";
  return error;
}

// Growth keeps the knot; the recovery schemes know nothing of it.
Result<void> start_is_tied_as_drawn(const Scene& scene, const RibbonMesh& ribbon,
                                    const FasteningProcessor& fastening) {
  if (scene.contact != ContactMethod::gate || fastening.start().kind != StartKind::recovered)
    return {};
  auto tied = check_tying(ribbon.grid, centre_axis(scene), ribbon.positions, fastening.positions());
  if (!tied) tied.error().place = scene.name;
  return tied;
}

// The first step at or after the time of frame `index`. A frame time that falls on a step up to
// rounding is on it.
long step_of_frame(const Scene& scene, int index) {
  const double steps = index / scene.recording.frames_per_second / scene.time.step_s;
  return static_cast<long>(std::ceil(steps - 1e-9 * (1 + steps)));
}

// What the steps since the last frame brought about.
class StepSums {
 public:
  void add(const StepReport& report) {
    ++steps_;
    recovery_iterations_ += report.recovery_iterations;
    penetrating_edges_ = report.penetrating_edges;
    held_back_ += report.held_back;
    pull_ += report.pull;
  }

  [[nodiscard]] std::uint32_t recovery_iterations() const {
    return static_cast<std::uint32_t>(recovery_iterations_);
  }
  // After the last step.
  [[nodiscard]] std::uint32_t penetrating_edges() const {
    return static_cast<std::uint32_t>(penetrating_edges_);
  }
  // Per step; before the first one nothing is held back and nobody has yielded.
  [[nodiscard]] double mean_held_back() const { return steps_ > 0 ? held_back_ / steps_ : 0; }
  [[nodiscard]] double mean_pull() const { return steps_ > 0 ? pull_ / steps_ : 1; }

 private:
  int steps_ = 0;
  long recovery_iterations_ = 0;
  int penetrating_edges_ = 0;
  double held_back_ = 0;
  double pull_ = 0;
};

std::optional<TightnessNumbers> tightness_numbers(FasteningProcessor& fastening,
                                                  const StepSums& sums, int particles) {
  const auto tightness = fastening.tightness();
  if (!tightness) return std::nullopt;
  return TightnessNumbers{.progress = static_cast<float>(tightness->progress),
                          .held_back = static_cast<float>(sums.mean_held_back() / particles),
                          .pull = static_cast<float>(sums.mean_pull()),
                          .contact = static_cast<float>(tightness->contact_share),
                          .rope_length = static_cast<float>(tightness->rope_length)};
}

FrameNumbers frame_numbers(FasteningProcessor& fastening, const StepSums& sums, int particles) {
  return {.time_s = fastening.time_s(),
          .worst_strain = fastening.strain(),
          .penetrating_edges = sums.penetrating_edges(),
          .recovery_iterations = sums.recovery_iterations(),
          .tightness = tightness_numbers(fastening, sums, particles)};
}

}  // namespace

int frame_count(const Scene& scene) {
  return static_cast<int>(
             std::floor(scene.time.duration_s * scene.recording.frames_per_second * (1 + 1e-12))) +
         1;
}

Result<RunStatistics> record(const Scene& scene, const std::filesystem::path& recording,
                             const std::string& writer, const RunObserver& observer) {
  const auto curve = centre_line(scene);
  if (!curve) return tl::unexpected(curve.error());
  const RibbonMesh ribbon = generate_ribbon_mesh(*curve, scene.ribbon, scene.curve.axis);
  std::optional<TriangleMesh> obstacle;
  if (scene.obstacle) {
    auto read = read_obstacle(*scene.obstacle);
    if (!read) return tl::unexpected(read.error());
    obstacle = std::move(*read);
  }
  Stopwatch stopwatch;
  auto fastening = FasteningProcessor::create(scene, ribbon, obstacle);
  if (!fastening) return tl::unexpected(with_tight_passage(scene, fastening.error()));
  if (auto tied = start_is_tied_as_drawn(scene, ribbon, *fastening); !tied)
    return tl::unexpected(tied.error());
  // Not before the start has been found: a scene without one leaves an older recording alone.
  auto file =
      RecordingWriter::create(recording, header_of(scene, writer, ribbon, obstacle, *fastening));
  if (!file) return tl::unexpected(file.error());

  RunStatistics statistics{.scene_name = scene.name,
                           .along = ribbon.grid.along,
                           .across = ribbon.grid.across,
                           .start = std::string(word_for(fastening->start().kind)),
                           .start_s = stopwatch.lap(),
                           .until_tight = scene.time.until == RunsUntil::tight};
  const int frames = frame_count(scene);
  for (int frame = 0; frame < frames && statistics.ending == RunEnding::unknown; ++frame) {
    StepSums sums;
    if (frame == 0)
      sums.add({.recovery_iterations = fastening->start().recovery_iterations,
                .penetrating_edges = fastening->start().penetrating_edges});
    for (const long last = step_of_frame(scene, frame); statistics.steps < last; ++statistics.steps)
      sums.add(fastening->step());
    statistics.simulation_s += stopwatch.lap();
    const FrameNumbers numbers = frame_numbers(*fastening, sums, ribbon.grid.particle_count());
    statistics.measuring_s += stopwatch.lap();
    if (auto written = file->append(numbers, fastening->positions()); !written)
      return tl::unexpected(written.error());
    statistics.recording_s += stopwatch.lap();
    statistics.add(numbers);
    if (!observer.frame_recorded(frame + 1, frames, numbers))
      statistics.ending = RunEnding::stopped;
    else if (statistics.until_tight && fastening->is_tight())
      statistics.ending = RunEnding::tight;
  }
  if (statistics.ending == RunEnding::unknown) statistics.ending = RunEnding::duration;
  statistics.stages = fastening->stage_sums();
  if (auto finished = file->finish(statistics.ending); !finished)
    return tl::unexpected(finished.error());
  statistics.bytes = file->bytes_written();
  return statistics;
}

}  // namespace ribbon
