#include "recorder/branch.h"

#include <array>
#include <optional>
#include <utility>

#include "recorder/copied_frames.h"
#include "recorder/run/recorded_run.h"
#include "recorder/run/start.h"
#include "ribbon_mesh/fabric_springs.h"
#include "ribbon_mesh/marks.h"
#include "ribbon_mesh/springs.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

namespace fs = std::filesystem;

std::optional<std::pair<const char*, const char*>> common_to_both_that_differs(const Scene& a,
                                                                               const Scene& b) {
  struct Rule {
    bool is_kept;
    const char* what;
    const char* why;
  };
  const auto size = [](const Scene& scene) {
    return std::array{scene.ribbon.along, scene.ribbon.across};
  };
  const auto widths = [](const Scene& scene) {
    return std::pair(scene.ribbon.width_m, row_widths_m(scene.ribbon));
  };
  // Particles and width first: a clearance that is left out depends on them.
  const std::array rules = {
      Rule{size(a) == size(b), "the number of particles", "all frames have the same particles"},
      Rule{widths(a) == widths(b), "ribbon.width", "the ribbon has grown to it"},
      Rule{a.curve == b.curve, "[curve]", "the ribbon has left its drawing"},
      Rule{a.knot == b.knot, "[knot]", "it is that of the drawing"},
      Rule{a.obstacle == b.obstacle, "[obstacle]", "the ribbon lies around it"},
      Rule{a.contact == b.contact, "contact", "the header tells what gap all frames keep"},
      Rule{a.fastening.has_value() == b.fastening.has_value(), "whether there is a [fastening]",
           "all frames tell how tight the ribbon is, or none does"},
      Rule{a.stages.size() == b.stages.size(), "the number of stages",
           "the ribbon is in one of them"},
      Rule{centre_axis(a) == centre_axis(b), "the axis of [fastening]",
           "the header names one axis for all frames"},
      // Else the scene would, by default, have fewer frames.
      Rule{b.time.step_s * a.recording.frames_per_second <= 1 + 1e-9, "time.step",
           "it would be longer than the time between two frames"},
      Rule{a.recording.frames_per_second == b.recording.frames_per_second,
           "recording.frames_per_second", "all frames are equally far apart"},
      Rule{a.recording.max_position_error == b.recording.max_position_error,
           "recording.max_position_error", "frames that are copied are as exact as they are"}};
  for (const Rule& rule : rules)
    if (!rule.is_kept) return std::pair(rule.what, rule.why);
  return std::nullopt;
}

// The recorded scene with the changes, as far as they are possible.
Result<RunPlan> plan_of_take(const Scene& recorded, const std::optional<TriangleMesh>& obstacle,
                             const std::vector<std::string>& settings, const RunLimit& limit) {
  auto plan = read_scene(recorded.file, recorded.text, settings, recorded.name)
                  .and_then([&](const Scene& scene) { return with_marks_found(scene, obstacle); })
                  .and_then([&](const Scene& scene) { return plan_of(scene, limit); });
  if (!plan) return plan;
  const auto fixed = common_to_both_that_differs(recorded, plan->scene);
  if (!fixed) return plan;
  return failure(recorded.file.string(),
                 filled_in("{} cannot change in a branch: {}", fixed->first, fixed->second),
                 "record a scene of its own");
}

// Nothing where both would go on to the same bits. stage: in which they go on.
Changed changed_in_take(Scene a, const Scene& b, std::optional<int> stage) {
  a.name = b.name;
  a.text = b.text;
  a.time.duration_s = b.time.duration_s;
  a.time.until = b.time.until;
  a.recording.checkpoint_every_s = b.recording.checkpoint_every_s;
  if (a == b) return Changed::nothing;
  if (!stage) return Changed::settings;
  const StageScene& one = a.stages[*stage];
  const StageScene& other = b.stages[*stage];
  const bool are_alike = one.hands == other.hands && one.goal == other.goal;
  return are_alike ? Changed::settings : Changed::hands;
}

Result<void> check_frame(RecordedRun& source, int frame, const RunPlan& plan) {
  const int number = frame + 1;
  const int frames = source.reader.frame_count();
  const auto refuse = [&](const std::string& problem, const std::string& remedy) {
    return failure(source.file.string(), problem, remedy);
  };
  if (frame < 0 || frame >= frames)
    return refuse(filled_in("there is no frame {}", number),
                  filled_in("name one from 1 to {}", frames));
  if (frame >= plan.frames)
    return refuse(
        filled_in("frame {} lies beyond the end of the branch, which is to have {} frames", number,
                  plan.frames),
        "branch off earlier, or add --until or --set time.duration");
  if (const auto lost = first_lost_frame(source.reader, number))
    return refuse(filled_in("frame {} is lost", *lost + 1),
                  "branch off before it, or repeat the run from its scene");
  return {};
}

Result<void> check_place(const fs::path& source, const NewRecording& take) {
  std::error_code code;
  if (fs::equivalent(source, take.file, code))
    return failure(take.file.string(), "a take cannot branch off into its own recording",
                   "name another file after -o");
  return take.check_place();
}

RecordingHeader header_of_take(const RecordingReader& source, int frame, const NewRecording& take,
                               const Scene& scene) {
  RecordingHeader header = source.header();
  header.origin =
      Origin{.recording_id = source.recording_id(),
             .scene_name = header.scene_name,
             .frame = static_cast<std::uint32_t>(frame),
             .changed_settings = take.settings_text() + fabric_settings(scene, rest_size(header))};
  header.scene_name = scene.name;
  header.scene_text = scene.text;
  for (std::size_t i = 0; i < header.stages.size(); ++i) header.stages[i] = scene.stages[i].name;
  header.writer = take.program;
  // Of the frames that are copied and of those that follow.
  header.limited_edges = common(header.limited_edges, limited_edges(scene));
  return header;
}

Result<void> copy_frames(RecordingReader& source, int count, RecordingWriter& target) {
  for (int frame = 0; frame < count; ++frame) {
    const auto quantised = source.read_quantised(frame);
    if (!quantised) return tl::unexpected(quantised.error());
    if (auto appended = target.append(*source.numbers(frame), **quantised); !appended)
      return appended;
  }
  return {};
}

// The copies must decode to what the frames were.
Result<void> check_copies(RecordingReader& source, int count, const RecordingWriter& target,
                          const fs::path& take) {
  auto copy = RecordingReader::open(target.present_path());
  if (!copy) return tl::unexpected(copy.error());
  for (int frame = 0; frame < count; ++frame)
    if (!same_frame(source, *copy, frame))
      return failure(filled_in("{}: frame {}", take.string(), frame + 1),
                     "it was not copied as it was", "report this; the source is as it was");
  return {};
}

// The writer calls copies safe, which go with the take.
Error without_take(Error error, const fs::path& take, bool is_older_there) {
  if (error.place != take.string()) return error;
  error.remedy =
      filled_in("{}; {} and branch off again",
                is_older_there ? "the older file is as it was" : "nothing of the take is there yet",
                error.may_pass ? "free some space" : "choose another place");
  return error;
}

// The take has its place once it can go on without its source: by the checkpoint of its last copy.
Result<RecordingWriter> begin_with_copies(const NewRecording& take, const RecordingHeader& header,
                                          RecordingReader& source, int count,
                                          FasteningProcessor& fastening) {
  auto target = RecordingWriter::create(
      take.file, header, take.overwrite == Overwrite::yes ? Overwrite::when_told : take.overwrite);
  if (!target) return target;
  const bool is_older_there = target->present_path() != take.file;
  const auto steps = static_cast<std::uint64_t>(fastening.steps());
  auto begun = copy_frames(source, count, *target);
  if (begun) begun = target->append_checkpoint(steps, fastening.state());
  if (!begun) begun.error() = without_take(std::move(begun.error()), take.file, is_older_there);
  if (begun) begun = check_copies(source, count, *target, take.file);
  if (begun) begun = target->take_place();
  if (begun) return target;
  target->take_back();
  return tl::unexpected(std::move(begun.error()));
}

}  // namespace

Result<std::optional<RunStatistics>> branch(const fs::path& file, int frame,
                                            const NewRecording& take, const RunObserver& observer,
                                            const RunLimit& limit) {
  const int copies = frame + 1;
  auto source = RecordedRun::open(file, copies);
  if (!source) return tl::unexpected(source.error());
  const auto plan =
      plan_of_take(source->scene, source->reader.header().obstacle, take.settings, limit);
  if (!plan) return tl::unexpected(plan.error());
  const Scene& scene = plan->scene;
  RecordingReader& reader = source->reader;
  Result<void> possible = check_place(file, take);
  if (possible) possible = check_frame(*source, frame, *plan);
  if (!possible) return tl::unexpected(possible.error());

  auto before = source->simulated_again(frame, observer.frame_simulated_again);
  if (!before) return tl::unexpected(before.error());
  if (!*before) return std::nullopt;
  auto fastening = FasteningProcessor::restore(
      scene, source->rest_size(), reader.header().obstacle, (*before)->fastening().state(),
      changed_in_take(source->scene, scene, (*before)->fastening().stage()));
  if (!fastening) return tl::unexpected(fastening.error());

  auto target = begin_with_copies(take, header_of_take(reader, frame, take, scene), reader, copies,
                                  *fastening);
  if (!target) return tl::unexpected(target.error());
  RunStatistics statistics = statistics_of(reader, copies);
  statistics.scene_name = scene.name;
  SimulatedFrames onward(scene, *std::move(fastening), frame);
  BackgroundWriter writer(*std::move(target));
  return run(onward, *plan, true, writer, observer, std::move(statistics));
}

}  // namespace ribbon
