#include "player/report/info.h"

#include <algorithm>

#include "inspection/tightness_progress_text.h"
#include "player/report/limited_edges_text.h"
#include "player/report/report_line.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// The worst of a number over all frames where it is known, and the first frame that has it.
template <class Function>
std::optional<WorstFrame> worst(const RecordingInfo& info, const Function& value) {
  std::optional<WorstFrame> result;
  for (int index = 0; index < info.frame_count(); ++index) {
    const auto& numbers = info.numbers[index];
    if (numbers && (!result || value(*numbers) > result->value))
      result = {static_cast<double>(value(*numbers)), index + 1};
  }
  return result;
}

const FrameNumbers* last_known(const RecordingInfo& info) {
  const auto last = std::find_if(info.numbers.rbegin(), info.numbers.rend(),
                                 [](const auto& frame) { return frame.has_value(); });
  return last == info.numbers.rend() ? nullptr : &**last;
}

std::string frames_text(const RecordingInfo& info) {
  std::string text = filled_in("{} in {:.2f} s, {:.6g} per second", info.frame_count(),
                               info.duration_s(), info.header.frames_per_second);
  if (info.finished) return text;
  return text + (info.being_written ? "; more are being recorded"
                                    : "; the recorder was stopped on the way");
}

// "key = value" a line, in one line.
std::string settings_text(const std::string& settings) {
  std::string text;
  for (const char letter : settings) text += letter == '\n' ? ' ' : letter;
  while (text.ends_with(' ')) text.pop_back();
  return text.empty() ? "" : ", with " + text;
}

std::string origin_text(const std::optional<Origin>& origin) {
  if (!origin) return "";
  return report_line("branch of",
                     filled_in("{}, from its frame {}{}", origin->scene_name, origin->frame + 1,
                               settings_text(origin->changed_settings)));
}

std::string sessions_text(const RecordingInfo& info) {
  std::string text;
  for (const Session& session : info.sessions)
    text += report_line(
        session.note.reason == SessionReason::unknown ? "resumed"
                                                      : std::string(word_for(session.note.reason)),
        filled_in("at frame {} by {}{}", session.first_frame + 1, session.note.program,
                  settings_text(session.note.changed_settings)));
  return text;
}

std::string checkpoints_text(const RecordingInfo& info) {
  constexpr std::size_t told = 3;  // at each end of a long list
  const std::vector<int>& frames = info.checkpoints;
  if (frames.empty()) return report_line("checkpoints", "none");
  std::string text = filled_in("{}, at frames ", frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (i >= told && i + told < frames.size()) {
      if (i == told) text += ", ...";
      continue;
    }
    text += (i > 0 ? ", " : "") + std::to_string(frames[i]);
  }
  return report_line("checkpoints", text);
}

std::string error_text(double max_position_error_m) {
  if (max_position_error_m == 0) return "none beyond rounding to single precision";
  return "at most " + length_text(max_position_error_m, 6, Rounding::up);
}

std::string obstacle_text(const RecordingInfo& info) {
  if (!info.header.obstacle) return "none";
  const TriangleMesh& mesh = *info.header.obstacle;
  return (mesh.name.empty() ? "" : mesh.name + ", ") +
         filled_in("{} vertices, {} triangles", mesh.vertices.cols(), mesh.triangles.cols());
}

std::string curve_text(const Eigen::Matrix3Xf& points) {
  return points.cols() == 0 ? "none" : filled_in("{} points", points.cols());
}

std::string gap_text(const RecordingHeader& header) {
  if (header.stated_gap_m == 0) return "none stated";
  return filled_in("at least {}, as stated", length_text(header.stated_gap_m, 6, Rounding::down));
}

std::string strain_limit_text(const RecordingHeader& header) {
  const std::string edges = "for " + limited_edges_text(header.limited_edges);
  if (header.strain_limit == 0)
    return "none stated" + (header.limited_edges.any() ? " " + edges : "");
  return short_number(100 * header.strain_limit, 6, Rounding::up) + " %, as stated " + edges;
}

std::string vector_text(const Eigen::Vector3d& vector) {
  return filled_in("({:.6g}, {:.6g}, {:.6g})", vector.x(), vector.y(), vector.z());
}

std::string axis_text(const std::optional<CentreAxis>& axis) {
  if (!axis) return "none";
  return "through " + vector_text(axis->point_m) + " m along " + vector_text(axis->direction);
}

std::string numbers_text(const RecordingInfo& info) {
  const auto strain = info.worst_strain();
  const auto penetrations = info.most_penetrations();
  if (!strain || !penetrations) return report_line("numbers", "none");
  return report_line("worst strain",
                     filled_in("{:.1f} % in frame {}", 100 * strain->value, strain->frame)) +
         report_line("penetrations", filled_in("at most {:.0f}, in frame {}; in the last frame {}",
                                               penetrations->value, penetrations->frame,
                                               *info.last_penetrations()));
}

// Empty where the recording does not tell.
std::string ending_text(RunEnding ending) {
  switch (ending) {
    case RunEnding::duration:
      return report_line("ended", "when its duration was over");
    case RunEnding::tight:
      return report_line("ended", "when the ribbon was tight");
    case RunEnding::stopped:
      return report_line("ended", "early, as the user asked");
    case RunEnding::limit:
      return report_line("ended", "at the limit that was asked for");
    case RunEnding::stages_over:
      return report_line("ended", "when its stages were over");
    case RunEnding::first_end_slips:
      return report_line("ended", "when its first end was about to slip out of its knot");
    case RunEnding::second_end_slips:
      return report_line("ended", "when its second end was about to slip out of its knot");
    case RunEnding::unknown:
      break;
  }
  return "";
}

std::string stages_text(const RecordingInfo& info) {
  std::string text;
  for (const StageFrames& stage : info.stages())
    text +=
        report_line("stage", filled_in("{}, frames {} to {}", stage.name, stage.first, stage.last));
  return text;
}

std::string tightness_text(const RecordingInfo& info) {
  const auto tightness = info.last_tightness();
  if (!tightness) return "";
  return report_line("last frame",
                     tightness_progress_text(tightness->progress) +
                         filled_in(", pull {:.1f} %, truncated {:.1f} %", 100 * tightness->pull,
                                   100 * tightness->truncated)) +
         report_line("", filled_in("in contact {:.1f} %, rope length {:.1f} widths",
                                   100 * tightness->contact, tightness->rope_length));
}

std::string memory_text(const RecordingInfo& info) {
  if (!info.memory_bytes) return "";
  return report_line("memory", filled_in("at most {:.0f} MB for pictures as asked for",
                                         static_cast<double>(*info.memory_bytes) / 1e6));
}

std::string damage_text(const RecordingInfo& info) {
  std::string text;
  for (const Damage& damage : info.damage)
    text += report_line(
        "damage", filled_in("{} bytes at byte {}: {}", damage.length, damage.byte, damage.reason));
  if (!info.missing.empty()) text += report_line("lost frames", number_list(info.missing));
  return text;
}

}  // namespace

double RecordingInfo::duration_s() const {
  const FrameNumbers* first = nullptr;
  const FrameNumbers* last = nullptr;
  for (const auto& frame : numbers) {
    if (!frame) continue;
    if (first == nullptr) first = &*frame;
    last = &*frame;
  }
  return first == nullptr ? 0 : last->time_s - first->time_s;
}

std::optional<WorstFrame> RecordingInfo::worst_strain() const {
  return worst(*this, [](const FrameNumbers& frame) { return frame.worst_strain; });
}

std::optional<WorstFrame> RecordingInfo::most_penetrations() const {
  return worst(*this, [](const FrameNumbers& frame) { return frame.penetrating_edges; });
}

std::optional<std::uint32_t> RecordingInfo::last_penetrations() const {
  const FrameNumbers* last = last_known(*this);
  return last == nullptr ? std::nullopt : std::optional(last->penetrating_edges);
}

std::optional<TightnessNumbers> RecordingInfo::last_tightness() const {
  const FrameNumbers* last = last_known(*this);
  return last == nullptr ? std::nullopt : last->tightness;
}

std::vector<StageFrames> RecordingInfo::stages() const {
  std::vector<StageFrames> stages;
  int lies_in = 0;
  for (int index = 0; index < frame_count(); ++index) {
    if (!numbers[index]) continue;  // a lost frame does not tell that a stage has ended
    const std::string name(stage_name(header, *numbers[index]));
    const int number = name.empty() ? 0 : numbers[index]->stage;
    if (number != 0 && number != lies_in) stages.push_back({number, name, index + 1, index + 1});
    if (number != 0) stages.back().last = index + 1;
    lies_in = number;
  }
  return stages;
}

double RecordingInfo::bytes_per_vertex_and_frame() const {
  if (numbers.empty()) return 0;
  return static_cast<double>(file_bytes) / static_cast<double>(numbers.size()) /
         header.grid.particle_count();
}

RecordingInfo recording_info(const std::filesystem::path& file, RecordingReader& reader) {
  RecordingInfo info;
  info.being_written = reader.is_being_written();  // before what has been written is looked at
  reader.check();
  info.file = file;
  info.file_bytes = reader.file_bytes();
  info.recording_id = reader.recording_id();
  info.finished = reader.finished();
  info.ending = reader.ending();
  info.header = reader.header();
  info.damage = reader.damage();
  info.sessions = reader.sessions();
  for (const std::uint32_t frame : reader.checkpoints())
    info.checkpoints.push_back(static_cast<int>(frame) + 1);
  for (int index = 0; index < reader.frame_count(); ++index) {
    info.numbers.push_back(reader.numbers(index));
    if (!reader.readable(index)) info.missing.push_back(index + 1);
  }
  return info;
}

std::string ribbon_text(const RecordingHeader& header) {
  const RestSize size = rest_size(header);
  return filled_in("{} x {} particles, ", header.grid.across, header.grid.along) +
         (size.has_profile() ? filled_in("{:.6g} to {:.6g} m wide, {:.6g} m in the mean",
                                         size.narrowest_m(), size.widest_m(), size.width_m)
                             : filled_in("{:.6g} m wide", size.width_m)) +
         filled_in(", {:.6g} m long", size.length_m);
}

std::string info_text(const RecordingInfo& info) {
  const RecordingHeader& header = info.header;
  return report_line("recording", info.file.string()) + report_line("scene", header.scene_name) +
         origin_text(header.origin) + report_line("written by", header.writer) +
         sessions_text(info) + report_line("frames", frames_text(info)) + stages_text(info) +
         ending_text(info.ending) +
         (info.outcome ? report_line("outcome", outcome_text(*info.outcome)) : "") +
         checkpoints_text(info) + report_line("ribbon", ribbon_text(header)) +
         report_line("input curve", curve_text(header.input_curve)) +
         report_line("obstacle", obstacle_text(info)) +
         report_line("centre axis", axis_text(header.centre_axis)) +
         report_line("gap", gap_text(header)) +
         report_line("strain limit", strain_limit_text(header)) + numbers_text(info) +
         tightness_text(info) +
         report_line("position error", error_text(header.max_position_error_m)) +
         report_line("size", filled_in("{} bytes, {:.2f} per vertex and frame", info.file_bytes,
                                       info.bytes_per_vertex_and_frame())) +
         memory_text(info) + damage_text(info);
}

}  // namespace ribbon
