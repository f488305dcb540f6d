#include <algorithm>
#include <cstdlib>
#include <iterator>

#include "player/report/limited_edges_text.h"
#include "player/report/report_line.h"
#include "player/report/verification_report.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

constexpr std::size_t most_changes = 3;

std::string particle_text(const RibbonGrid& grid, int particle) {
  return filled_in("row {} column {}", grid.row(particle), grid.column(particle));
}

std::string triangle_text(const RibbonGrid& grid, int triangle) {
  if (triangle >= grid.triangle_count())
    return filled_in("obstacle triangle {}", triangle - grid.triangle_count());
  return "ribbon " + particle_text(grid, grid.quad(triangle / 2)[0]);
}

std::string pair_text(const RibbonGrid& grid, const TrianglePair& pair) {
  return triangle_text(grid, pair.first) + " and " + triangle_text(grid, pair.second);
}

std::string counted(long long count, const std::string& thing) {
  return filled_in("{} {}{}", count, thing, std::abs(count) == 1 ? "" : "s");
}

std::string moment_text(int frame, const std::optional<double>& time_s) {
  return time_s ? filled_in("frame {} ({:.2f} s)", frame, *time_s) : filled_in("frame {}", frame);
}

std::string frames_text(const Verification& verification) {
  std::string text =
      filled_in("{} of {} checked", verification.frames_checked, verification.frames_asked);
  if (!verification.lost.empty()) text += "; lost: " + number_list(verification.lost);
  if (!verification.not_finite.empty())
    text += "; with coordinates that are no numbers: " + number_list(verification.not_finite);
  return text;
}

std::string intersections_text(const Verification& verification) {
  if (verification.intersecting_pairs == 0) return report_line("intersections", "none");
  const auto& most = *verification.most_intersections;
  std::string text = report_line(
      "intersections",
      filled_in("{}{} of triangles in {}, most in frame {}: {}",
                verification.all_pairs_counted ? "" : "at least ",
                counted(static_cast<long long>(verification.intersecting_pairs), "pair"),
                counted(verification.intersecting_frames, "frame"), most.frame, most.pairs));
  for (const Intersection& example : verification.first_intersections)
    text += report_line("", moment_text(example.frame, example.time_s) + ": " +
                                pair_text(verification.header.grid, example.pair));
  return text;
}

std::string stated_text(const Verification& verification) {
  const double stated_m = verification.header.stated_gap_m;
  if (stated_m == 0) return "none is stated";
  return filled_in("{} the stated {} m", verification.keeps_stated_gap() ? "at least" : "LESS than",
                   short_number(stated_m, 6, Rounding::down));
}

std::string gap_text(const Verification& verification) {
  if (!verification.smallest_gap) return "not known";
  const auto& [gap, frame] = *verification.smallest_gap;
  return filled_in("{} m in frame {}, {}; {}", short_number(gap.certain_m, 6, Rounding::down),
                   frame, pair_text(verification.header.grid, gap.pair), stated_text(verification));
}

std::string strain_limit_text(const Verification& verification) {
  const double limit = verification.header.strain_limit;
  if (limit == 0) return "no limit is stated";
  return filled_in("{} the stated {} %", verification.keeps_strain_limit() ? "within" : "BEYOND",
                   short_number(100 * limit, 6, Rounding::up));
}

std::string strain_text(const Verification& verification) {
  const RecordingHeader& header = verification.header;
  if (!header.limited_edges.any())
    return "not known: the recording names no edges that are limited";
  if (!verification.largest_strain) return "not known";
  const auto& [strain, frame] = *verification.largest_strain;
  return filled_in("{:.4g} % of {}, in frame {}, from {} to {}; {}", 100 * strain.strain,
                   limited_edges_text(header.limited_edges), frame,
                   particle_text(header.grid, strain.first),
                   particle_text(header.grid, strain.second), strain_limit_text(verification));
}

std::string slipped_text(const CertifiedKnot& knot) {
  if (!knot.closed_anew) return ", though an end may have slipped out";
  return ", and closed anew the last frame is " +
         (knot.closed_anew->is_the_same
              ? "the same knot"
              : knot.closed_anew->knot + ": an end has slipped out, or lies in a loop");
}

std::string buried_text(const CertifiedKnot& knot) {
  if (!knot.buried_since) return "";
  std::string text =
      filled_in("from frame {} on an end is buried in the ribbon", *knot.buried_since);
  if (knot.may_have_passed)
    text += filled_in(
        "; its centre line may have passed through itself between frames {} and {}, where a "
        "particle went up to {:.2g} m; record more frames_per_second",
        knot.may_have_passed->frame_before, knot.may_have_passed->frame_after,
        knot.may_have_passed->moved_m);
  else if (knot.uncertain_frames == 0)
    text += "; its centre line has not passed through itself since" + slipped_text(knot);
  return report_line("", text);
}

std::string changes_text(const CertifiedKnot& knot) {
  std::string text = buried_text(knot);
  const int known = knot.certified_frames - knot.uncertain_frames;
  const std::string certified = counted(known, "frame") + " certified";
  if (knot.uncertain_frames > 0)
    text += report_line("", "not known in " + counted(knot.uncertain_frames, "frame"));
  if (knot.turned_too_far)
    text += report_line(
        "", filled_in("between frames {} and {} an end went or turned too far from frame to "
                      "frame to see which way; record more frames_per_second",
                      knot.turned_too_far->frame_before, knot.turned_too_far->frame_after));
  if (known == 0) return text;
  const auto& changes = knot.changes;
  if (changes.empty()) return text + report_line("", "the same in all of " + certified);
  text += report_line("", "CHANGED " + counted(std::ssize(changes), "time") + "; " + certified);
  for (std::size_t k = 0; k < std::min(most_changes, changes.size()); ++k) {
    text += report_line("", filled_in("frame {}: {}", changes[k].frame_before, changes[k].before));
    text += report_line("", filled_in("frame {}: {}", changes[k].frame_after, changes[k].after));
    text += report_line(
        "", filled_in("meanwhile a particle went up to {:.2g} m from frame to frame; if that is "
                      "far, record more frames_per_second to be sure",
                      changes[k].moved_m));
  }
  return text;
}

std::string expectation_text(const PartVerification& part) {
  if (part.expected.empty()) return "";
  const int others = part.knot.unexpected_frames;
  return report_line("", others == 0 ? "as expected: " + part.expected
                                     : filled_in("NOT as expected in {}: {}",
                                                 counted(others, "frame"), part.expected));
}

std::string part_text(const PartVerification& part) {
  const bool known = part.knot.certified_frames > 0;
  return report_line("between",
                     filled_in("rows {} and {}: {}", part.rows.first_row, part.rows.last_row,
                               known ? part.knot.certificate : "not known")) +
         (known ? expectation_text(part) + changes_text(part.knot) : "");
}

std::string knot_text(const Verification& verification) {
  const CertifiedKnot& knot = verification.knot;
  std::string text = knot.certified_frames > 0
                         ? report_line("knot", knot.certificate) + changes_text(knot)
                         : report_line("knot", "not known");
  for (const PartVerification& part : verification.parts) text += part_text(part);
  return text;
}

std::string outcome_lines(const Verification& verification) {
  std::string text;
  if (verification.outcome) text += report_line("outcome", outcome_text(*verification.outcome));
  const auto& passages = verification.passages_over_ends;
  for (std::size_t k = 0; k < std::min(most_changes, passages.size()); ++k)
    text += report_line(
        "", filled_in("{}: over an end of the object, from {} to {}",
                      moment_text(passages[k].frame, passages[k].time_s),
                      counted(passages[k].turns_before, "turn"), passages[k].turns_after));
  if (passages.size() > most_changes)
    text += report_line("", filled_in("and {} more", passages.size() - most_changes));
  return text;
}

std::string verdict_text(const Verification& verification) {
  std::string text;
  for (const std::string& complaint : verification.complaints())
    text += (text.empty() ? "" : ", ") + complaint;
  return text.empty() ? "nothing is wrong" : "WRONG: " + text;
}

}  // namespace

std::string verification_text(const std::string& file, const Verification& verification) {
  return report_line("recording", file) + report_line("frames", frames_text(verification)) +
         intersections_text(verification) + report_line("smallest gap", gap_text(verification)) +
         report_line("largest strain", strain_text(verification)) + knot_text(verification) +
         outcome_lines(verification) + report_line("verdict", verdict_text(verification));
}

}  // namespace ribbon
