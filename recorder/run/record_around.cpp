#include "recorder/run/record_around.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "curve/outline.h"
#include "recorder/run/drawn_knot.h"
#include "recorder/run/start.h"
#include "recorder/run/stopwatch.h"
#include "ribbon_mesh/fabric_springs.h"
#include "ribbon_mesh/marks.h"
#include "ribbon_mesh/springs.h"

namespace ribbon {

namespace {

// As many as a recording holds.
std::vector<RecordedMark> recorded_marks(const Scene& scene, const RibbonMesh& ribbon) {
  std::vector<RecordedMark> marks;
  for (const PlacedMark& mark : marks_on(scene.curve, ribbon))
    if (marks.size() < most_recorded_marks) marks.push_back({mark.id, mark.share});
  return marks;
}

std::optional<KnotBetween> knot_between(const Scene& scene) {
  if (!scene.knot || !scene.knot->between) return std::nullopt;
  const auto& expected = scene.knot->expect_between;
  return KnotBetween{shares_of(*scene.knot->between), expected ? expected->name : ""};
}

RecordingHeader header_of_run(const Scene& scene, const std::string& program, const Start& start,
                              const std::optional<TriangleMesh>& obstacle) {
  const RibbonMesh& ribbon = start.ribbon;
  RecordingHeader header;
  header.scene_name = scene.name;
  header.scene_text = scene.text;
  header.writer = program;
  header.grid = ribbon.grid;
  header.uv = ribbon.uv;
  header.ribbon_length_m = ribbon.length_m;
  header.ribbon_width_m = ribbon.width_m;
  header.row_widths_m = ribbon.row_widths_m;
  header.frames_per_second = scene.recording.frames_per_second;
  header.max_position_error_m = start.fastening.max_position_error_m();
  header.quantisation_step_m =
      quantisation_step_m(header.max_position_error_m,
                          start.fastening.positions().cwiseAbs().maxCoeff(), ribbon.length_m);
  header.obstacle = obstacle;
  header.stated_gap_m = start.fastening.guaranteed_gap_m();
  header.centre_axis = centre_axis(scene);
  header.limited_edges = limited_edges(scene);
  header.strain_limit = start.fastening.guaranteed_strain();
  for (const StageScene& stage : scene.stages) header.stages.push_back(stage.name);
  header.input_curve = ribbon.curve.cast<float>();
  header.marks = recorded_marks(scene, ribbon);
  header.knot_between = knot_between(scene);
  return header;
}

}  // namespace

Result<std::unique_ptr<BegunRun>> begin_recording(const std::optional<TriangleMesh>& obstacle,
                                                  const Scene& wanted,
                                                  const NewRecording& recording,
                                                  const StartObserver& observer,
                                                  const RunLimit& limit) {
  if (auto place = recording.check_place(); !place) return tl::unexpected(place.error());
  auto plan = with_outline_read(wanted)
                  .and_then([&](const Scene& scene) { return with_marks_found(scene, obstacle); })
                  .and_then([&](const Scene& scene) { return plan_of(scene, limit); });
  if (!plan) return tl::unexpected(plan.error());
  const Scene& scene = plan->scene;
  Stopwatch stopwatch;
  auto start = find_start(scene, obstacle, observer);
  if (!start) return tl::unexpected(start.error());
  const double start_s = stopwatch.lap();
  // Not before the start has been found: a scene without one leaves an older recording alone.
  auto target = RecordingWriter::create(recording.file,
                                        header_of_run(scene, recording.program, *start, obstacle),
                                        recording.overwrite);
  if (!target) return tl::unexpected(target.error());
  const std::string settings =
      recording.settings_text() + fabric_settings(scene, start->ribbon.size());
  const RunStatistics statistics{.scene_name = scene.name,
                                 .along = start->ribbon.grid.along,
                                 .across = start->ribbon.grid.across,
                                 .start_s = start_s};
  SimulatedFrames frames(scene, std::move(start->fastening), -1);
  std::unique_ptr<BegunRun> begun(new BegunRun{
      *std::move(plan), BackgroundWriter(*std::move(target)), std::move(frames), statistics});
  if (!settings.empty())
    begun->file.append_session({.reason = SessionReason::begun,
                                .program = recording.program,
                                .changed_settings = settings});
  return begun;
}

Result<RunStatistics> record_around(const std::optional<TriangleMesh>& obstacle, const Scene& scene,
                                    const NewRecording& recording, const RunObserver& observer,
                                    const RunLimit& limit) {
  auto begun = begin_recording(obstacle, scene, recording, observer.start_sought, limit);
  if (!begun) return tl::unexpected(begun.error());
  BegunRun& one = **begun;
  return run(one.frames, one.plan, false, one.file, observer, one.statistics);
}

}  // namespace ribbon
