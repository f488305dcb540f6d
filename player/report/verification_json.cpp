#include "inspection/figures_json.h"
#include "player/report/limited_edges_text.h"
#include "player/report/verification_report.h"
#include "text/json.h"

namespace ribbon {

namespace {

Json triangle_json(const RibbonGrid& grid, int triangle) {
  if (triangle >= grid.triangle_count())
    return {{"obstacle_triangle", triangle - grid.triangle_count()}};
  const int corner = grid.quad(triangle / 2)[0];
  return {
      {"ribbon_triangle", triangle}, {"row", grid.row(corner)}, {"column", grid.column(corner)}};
}

Json pair_json(const RibbonGrid& grid, const TrianglePair& pair) {
  return Json::list({triangle_json(grid, pair.first), triangle_json(grid, pair.second)});
}

Json particle_json(const RibbonGrid& grid, int particle) {
  return {{"row", grid.row(particle)}, {"column", grid.column(particle)}};
}

Json intersections_json(const Verification& verification) {
  Json first = Json::list({});
  for (const Intersection& example : verification.first_intersections)
    first.add({{"frame", example.frame},
               {"time_s", example.time_s},
               {"between", pair_json(verification.header.grid, example.pair)}});
  const auto& most = verification.most_intersections;
  return {{"pairs", verification.intersecting_pairs},
          {"all_counted", verification.all_pairs_counted},
          {"frames", verification.intersecting_frames},
          {"most", most ? Json{{"frame", most->frame}, {"pairs", most->pairs}} : Json()},
          {"first", first}};
}

Json gap_json(const Verification& verification) {
  const double stated_m = verification.header.stated_gap_m;
  Json json{{"stated_m", stated_m > 0 ? Json(stated_m) : Json()},
            {"kept", verification.keeps_stated_gap()}};
  if (!verification.smallest_gap) return json;
  const auto& [gap, frame] = *verification.smallest_gap;
  json.set("smallest_m", gap.certain_m);
  json.set("frame", frame);
  json.set("between", pair_json(verification.header.grid, gap.pair));
  return json;
}

Json strain_json(const Verification& verification) {
  const RecordingHeader& header = verification.header;
  Json json{{"edges", words_for(header.limited_edges)},
            {"limit", header.strain_limit > 0 ? Json(header.strain_limit) : Json()},
            {"kept", verification.keeps_strain_limit()}};
  if (!verification.largest_strain) return json;
  const auto& [strain, frame] = *verification.largest_strain;
  json.set("largest", strain.strain);
  json.set("frame", frame);
  json.set("between", Json::list({particle_json(header.grid, strain.first),
                                  particle_json(header.grid, strain.second)}));
  return json;
}

Json passages_json(const std::vector<PassageOverEnd>& passages) {
  Json list = Json::list({});
  for (const PassageOverEnd& passage : passages)
    list.add({{"frame", passage.frame},
              {"time_s", passage.time_s},
              {"turns_before", passage.turns_before},
              {"turns_after", passage.turns_after}});
  return list;
}

Json change_json(const CertificateChange& change) {
  return {{"frame_before", change.frame_before},
          {"frame_after", change.frame_after},
          {"before", change.before},
          {"after", change.after},
          {"moved_m", change.moved_m}};
}

Json far_move_json(const FarMove& move) {
  return {{"frame_before", move.frame_before},
          {"frame_after", move.frame_after},
          {"moved_m", move.moved_m}};
}

Json closed_anew_json(const ClosedAnew& last) {
  return {{"knot", last.knot}, {"is_the_same", last.is_the_same}};
}

Json certified_json(const CertifiedKnot& knot) {
  Json changes = Json::list({});
  for (const CertificateChange& change : knot.changes) changes.add(change_json(change));
  return {{"certificate", knot.certified_frames > 0 ? Json(knot.certificate) : Json()},
          {"certified_frames", knot.certified_frames},
          {"buried_frames", knot.buried_frames},
          {"uncertain_frames", knot.uncertain_frames},
          {"buried_since", knot.buried_since},
          {"closed_anew", knot.closed_anew ? closed_anew_json(*knot.closed_anew) : Json()},
          {"may_have_passed", knot.may_have_passed ? far_move_json(*knot.may_have_passed) : Json()},
          {"turned_too_far", knot.turned_too_far ? change_json(*knot.turned_too_far) : Json()},
          {"changes", changes}};
}

Json parts_json(const std::vector<PartVerification>& parts) {
  Json list = Json::list({});
  for (const PartVerification& part : parts) {
    Json json = certified_json(part.knot);
    json.set("first_row", part.rows.first_row);
    json.set("last_row", part.rows.last_row);
    json.set("expected", part.expected.empty() ? Json() : Json(part.expected));
    json.set("is_expected",
             part.expected.empty() ? Json() : Json(part.knot.unexpected_frames == 0));
    list.add(json);
  }
  return list;
}

Json knot_json(const Verification& verification) {
  Json json = certified_json(verification.knot);
  json.set("passages_over_ends", passages_json(verification.passages_over_ends));
  json.set("between", parts_json(verification.parts));
  return json;
}

}  // namespace

std::string verification_json(const std::string& file, const Verification& verification) {
  const auto complaints = verification.complaints();
  const Json json{{"file", file},
                  {"passed", complaints.empty()},
                  {"wrong", complaints},
                  {"frames",
                   {{"asked", verification.frames_asked},
                    {"checked", verification.frames_checked},
                    {"lost", verification.lost},
                    {"not_finite", verification.not_finite}}},
                  {"intersections", intersections_json(verification)},
                  {"gap", gap_json(verification)},
                  {"strain", strain_json(verification)},
                  {"knot", knot_json(verification)},
                  {"outcome", outcome_json(verification.outcome)}};
  return json.text();
}

}  // namespace ribbon
