#include "inspection/figures_json.h"
#include "player/report/info.h"
#include "player/report/limited_edges_text.h"
#include "text/json.h"

namespace ribbon {

namespace {

Json worst_json(const std::optional<WorstFrame>& worst) {
  if (!worst) return nullptr;
  return {{"value", worst->value}, {"frame", worst->frame}};
}

Json obstacle_json(const std::optional<TriangleMesh>& obstacle) {
  if (!obstacle) return nullptr;
  return {{"name", obstacle->name},
          {"vertices", obstacle->vertices.cols()},
          {"triangles", obstacle->triangles.cols()}};
}

Json vector_json(const Eigen::Vector3d& vector) {
  return Json::list({vector.x(), vector.y(), vector.z()});
}

Json curve_json(const Eigen::Matrix3Xf& points) {
  if (points.cols() == 0) return nullptr;
  return {{"points", points.cols()}};
}

Json axis_json(const std::optional<CentreAxis>& axis) {
  if (!axis) return nullptr;
  return {{"point_m", vector_json(axis->point_m)}, {"direction", vector_json(axis->direction)}};
}

Json penetrations_json(const RecordingInfo& info) {
  const auto last = info.last_penetrations();
  return {{"worst", worst_json(info.most_penetrations())}, {"last", last}};
}

Json damage_json(const std::vector<Damage>& damage) {
  Json list = Json::list({});
  for (const Damage& part : damage)
    list.add({{"byte", part.byte}, {"length", part.length}, {"reason", part.reason}});
  return list;
}

Json ending_json(RunEnding ending) {
  if (ending == RunEnding::unknown) return nullptr;
  return word_for(ending);
}

Json origin_json(const std::optional<Origin>& origin) {
  if (!origin) return nullptr;
  return {{"recording_id", origin->recording_id},
          {"scene", origin->scene_name},
          {"frame", origin->frame + 1},
          {"changed_settings", origin->changed_settings}};
}

Json sessions_json(const std::vector<Session>& sessions) {
  Json list = Json::list({});
  for (const Session& session : sessions)
    list.add({{"first_frame", session.first_frame + 1},
              {"reason", word_for(session.note.reason)},
              {"program", session.note.program},
              {"changed_settings", session.note.changed_settings}});
  return list;
}

Json stages_json(const RecordingInfo& info) {
  Json list = Json::list({});
  for (const StageFrames& stage : info.stages())
    list.add({{"name", stage.name}, {"first_frame", stage.first}, {"last_frame", stage.last}});
  return list;
}

Json frames_json(const RecordingInfo& info) {
  Json list = Json::list({});
  for (int index = 0; index < info.frame_count(); ++index) {
    const auto& numbers = info.numbers[index];
    Json frame{{"frame", index + 1}};
    frame.set("time_s", numbers ? Json(numbers->time_s) : Json());
    frame.set("worst_strain", numbers ? Json(numbers->worst_strain) : Json());
    frame.set("penetrating_edges", numbers ? Json(numbers->penetrating_edges) : Json());
    frame.set("recovery_iterations", numbers ? Json(numbers->recovery_iterations) : Json());
    frame.set("tightness", tightness_json(numbers ? numbers->tightness : std::nullopt));
    list.add(std::move(frame));
  }
  return list;
}

}  // namespace

std::string info_json(const RecordingInfo& info) {
  const RecordingHeader& header = info.header;
  const Json json{{"file", info.file.string()},
                  {"file_bytes", info.file_bytes},
                  {"bytes_per_vertex_and_frame", info.bytes_per_vertex_and_frame()},
                  {"recording_id", info.recording_id},
                  {"writer", header.writer},
                  {"finished", info.finished},
                  {"being_written", info.being_written},
                  {"ending", ending_json(info.ending)},
                  {"outcome", outcome_json(info.outcome)},
                  {"scene", {{"name", header.scene_name}, {"text", header.scene_text}}},
                  {"origin", origin_json(header.origin)},
                  {"sessions", sessions_json(info.sessions)},
                  {"stages", stages_json(info)},
                  {"ribbon",
                   {{"along", header.grid.along},
                    {"across", header.grid.across},
                    {"length_m", header.ribbon_length_m},
                    {"width_m", header.ribbon_width_m},
                    {"narrowest_m", rest_size(header).narrowest_m()},
                    {"widest_m", rest_size(header).widest_m()}}},
                  {"input_curve", curve_json(header.input_curve)},
                  {"obstacle", obstacle_json(header.obstacle)},
                  {"centre_axis", axis_json(header.centre_axis)},
                  {"stated_gap_m", header.stated_gap_m > 0 ? Json(header.stated_gap_m) : Json()},
                  {"limited_edges", words_for(header.limited_edges)},
                  {"strain_limit", header.strain_limit > 0 ? Json(header.strain_limit) : Json()},
                  {"frame_count", info.frame_count()},
                  {"frames_per_second", header.frames_per_second},
                  {"duration_s", info.duration_s()},
                  {"max_position_error_m", header.max_position_error_m},
                  {"worst_strain", worst_json(info.worst_strain())},
                  {"penetrating_edges", penetrations_json(info)},
                  {"memory_bytes", info.memory_bytes},
                  {"checkpoints", info.checkpoints},
                  {"missing_frames", info.missing},
                  {"damage", damage_json(info.damage)},
                  {"frames", frames_json(info)}};
  return json.text();
}

}  // namespace ribbon
