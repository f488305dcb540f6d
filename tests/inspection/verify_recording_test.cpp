#include "inspection/verify_recording.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "files/files.h"
#include "files/flipped.h"
#include "inspection/looped_ribbon.h"
#include "knot/knotted_curves.h"
#include "recording/sample_recording.h"
#include "result/refusal.h"

namespace ribbon::verify_recording_test {

Verification verify_file(const std::filesystem::path& path, std::vector<int> frames = {},
                         int certify_every = 10) {
  auto reader = RecordingReader::open(path).value();
  if (frames.empty()) {
    frames.resize(reader.frame_count());
    std::iota(frames.begin(), frames.end(), 0);
  }
  return verify_recording(reader, {std::move(frames), certify_every}, [](int) { return true; })
      .value();
}

Verification verify_frames(const RecordingHeader& header,
                           const std::vector<Eigen::Matrix3Xd>& frames) {
  const auto path = temporary_file("verify.rbn");
  std::filesystem::remove(path);
  write_recording(path, header, frames);
  return verify_file(path);
}

std::filesystem::path sample(int frames, Ending ending = Ending::finished) {
  auto path = temporary_file("sample to verify.rbn");
  std::filesystem::remove(path);
  write_sample_recording(path, frames, ending);
  return path;
}

using Complaints = std::vector<std::string>;

TEST(Verify, the_sample_is_in_order) {
  const Verification verification = verify_file(sample(7));
  EXPECT_EQ(verification.complaints(), Complaints{});
  EXPECT_EQ(verification.frames_checked, 7);
  EXPECT_EQ(verification.intersecting_pairs, 0U);
  EXPECT_GT(verification.smallest_gap->gap.certain_m, 1e-3);
  EXPECT_EQ(verification.knot.certified_frames, 2);
}

TEST(Verify, a_recorder_that_was_stopped_leaves_nothing_wrong) {
  EXPECT_EQ(verify_file(sample(7, Ending::killed)).complaints(), Complaints{});
}

TEST(Verify, all_that_is_wrong_is_told) {
  Verification verification;
  verification.intersecting_pairs = 1;
  verification.header.stated_gap_m = 1e-4;
  verification.smallest_gap = {{9e-5, {0, 1}}, 1};
  verification.knot.changes.emplace_back();
  verification.knot.uncertain_frames = 1;
  verification.parts.emplace_back();
  verification.parts[0].knot.changes.emplace_back();
  verification.parts[0].knot.uncertain_frames = 1;
  verification.parts[0].knot.unexpected_frames = 1;
  verification.not_finite = {3};
  verification.lost = {4};
  verification.damaged = true;
  EXPECT_EQ(verification.complaints(),
            (Complaints{"triangles intersect", "the stated gap is not kept", "the knot has changed",
                        "the knot cannot be certified", "the knot of a part has changed",
                        "the knot of a part cannot be certified",
                        "the knot of a part is not the one expected", "coordinates are no numbers",
                        "frames are lost"}));
}

TEST(Verify, a_lost_frame_is_wrong_and_elsewhere_than_asked_for_the_file_is_damaged) {
  const auto last_begins = std::filesystem::file_size(sample(6, Ending::killed));
  const auto path = sample(7, Ending::killed);
  ASSERT_TRUE(write_file(path, flipped(read_file(path).value(), last_begins + 100)));
  const Verification verification = verify_file(path);
  EXPECT_EQ(verification.lost, std::vector<int>{7});
  EXPECT_EQ(verification.frames_checked, 6);
  EXPECT_EQ(verification.complaints(), Complaints{"frames are lost"});
  EXPECT_EQ(verify_file(path, {0, 1}).complaints(), Complaints{"the file is damaged"});
}

TEST(Verify, only_the_frames_asked_for_are_checked_and_certified) {
  const auto path = sample(40);
  EXPECT_EQ(verify_file(path, {4, 5, 20}).frames_checked, 3);
  EXPECT_EQ(verify_file(path, {4, 5, 20}, 8).knot.certified_frames, 3);   // 4, 12, 20
  EXPECT_EQ(verify_file(path, {4, 5, 20}, 10).knot.certified_frames, 3);  // 4, 14, 20
  EXPECT_EQ(verify_file(path, {4, 5, 20}, 16).knot.certified_frames, 2);  // 4, 20
  EXPECT_EQ(verify_file(path, {4}).knot.certified_frames, 1);
}

TEST(Verify, a_knot_that_is_not_known_has_not_changed) {
  const RecordingHeader header = header_with_post();
  KnotCertifier knot(header.grid, {}, {}, "");
  const Eigen::Matrix3Xf loop = looped_ribbon(header, {}).cast<float>();
  knot.follow(0, loop, true);
  knot.follow(1, Eigen::Matrix3Xf::Zero(3, loop.cols()), true);
  const CertifiedKnot certified = knot.finish();
  EXPECT_EQ(certified.certified_frames, 2);
  EXPECT_EQ(certified.uncertain_frames, 1);
  EXPECT_TRUE(certified.changes.empty());
}

// The looped ribbon, its last quarter turned about its line, more and more towards its end.
Eigen::Matrix3Xf loop_with_end_turned(const RecordingHeader& header, double full_turns) {
  Eigen::Matrix3Xd positions = looped_ribbon(header, {});
  for (int row = 150; row < header.grid.along; ++row) {
    const auto of_row = positions.middleCols(header.grid.particle(row, 0), 2);
    const Eigen::Vector3d middle = of_row.rowwise().mean();
    const double turn_rad = 2 * std::numbers::pi * full_turns * (row - 150) / 49.0;
    const Eigen::AngleAxisd turn(turn_rad, Eigen::Vector3d::UnitX());
    positions.middleCols(header.grid.particle(row, 0), 2) =
        ((turn.toRotationMatrix() * (of_row.colwise() - middle)).colwise() + middle).eval();
  }
  return positions.cast<float>();
}

CertifiedKnot certified_while_an_end_turns(const std::vector<double>& full_turns) {
  const RecordingHeader header = header_with_post();
  KnotCertifier knot(header.grid, {}, {}, "");
  for (std::size_t frame = 0; frame < full_turns.size(); ++frame)
    knot.follow(static_cast<int>(frame), loop_with_end_turned(header, full_turns[frame]), true);
  return knot.finish();
}

TEST(Verify, an_end_that_turns_slowly_hides_nothing) {
  const CertifiedKnot knot = certified_while_an_end_turns({0, 0.2, 0.4, 0.6, 0.8, 1});
  EXPECT_EQ(knot.uncertain_frames, 0);
  EXPECT_FALSE(knot.turned_too_far);
  EXPECT_TRUE(knot.changes.empty());
}

TEST(Verify, an_end_that_turns_too_far_between_frames_leaves_the_twist_unknown) {
  const CertifiedKnot knot = certified_while_an_end_turns({0, 0.2, 0.8, 0.9, 0.3});
  EXPECT_TRUE(knot.changes.empty());
  EXPECT_EQ(knot.uncertain_frames, 2);  // until it has turned back the way it came
  ASSERT_TRUE(knot.turned_too_far);
  EXPECT_EQ(knot.turned_too_far->frame_before, 2);
  EXPECT_EQ(knot.turned_too_far->frame_after, 3);
}

TEST(Verify, a_turned_end_explains_no_other_change) {
  const RecordingHeader header = header_with_post();
  for (const double by_turns : {0.2, 0.6}) {
    KnotCertifier knot(header.grid, {}, object_axis(header.centre_axis, header.obstacle), "");
    knot.follow(0, loop_with_end_turned(header, 0), true);
    Eigen::Matrix3Xf passed = loop_with_end_turned(header, by_turns);
    passed.row(2).array() -= 0.5F;  // through the post
    knot.follow(1, passed, true);
    const CertifiedKnot certified = knot.finish();
    ASSERT_EQ(certified.changes.size(), 1U) << by_turns;
    EXPECT_NEAR(certified.changes[0].moved_m, 0.5, loop_width_m);
  }
}

// A ball of ribbon whose hole closes over the end within, certified in every `every`-th frame.
CertifiedKnot certified_balls(const std::vector<Eigen::Matrix3Xf>& frames, int every) {
  KnotCertifier knot({700, 2}, {}, {}, "");
  for (int frame = 0; frame < static_cast<int>(frames.size()); ++frame)
    knot.follow(frame, frames[frame], frame % every == 0);
  return knot.finish();
}

Eigen::Matrix3Xf ball(double hole_rad, double windings = 60, double twist_turns = 0) {
  return ribbon_along(ball_with_hole(hole_rad, windings), 2, 0.01, twist_turns);
}

TEST(Verify, a_knot_whose_end_gets_buried_is_the_same_while_nothing_passes) {
  const CertifiedKnot knot =
      certified_balls({ball(0.6), ball(0.3), ball(0.02), ball(0.03), ball(0.02)}, 2);
  EXPECT_EQ(knot.buried_since, 3);
  EXPECT_EQ(knot.certified_frames, 4);  // 1, 2 (the last that is closed), 3, 5
  EXPECT_EQ(knot.buried_frames, 2);
  EXPECT_EQ(knot.uncertain_frames, 0);
  EXPECT_TRUE(knot.changes.empty());
  EXPECT_FALSE(knot.may_have_passed);
  EXPECT_FALSE(knot.closed_anew) << "the last frame has no closure";
}

// What a ribbon is at last tells the closure of its last frame alone.
TEST(Verify, a_knot_whose_end_was_buried_is_closed_anew_in_the_last_frame) {
  const auto still = certified_balls({ball(0.6), ball(0.02), ball(0.6)}, 1).closed_anew;
  ASSERT_TRUE(still);
  EXPECT_TRUE(still->is_the_same);
  EXPECT_EQ(still->knot, "unknot");

  const auto untied =
      certified_balls({open_trefoil({700, 2}, 1, 0.01).cast<float>(), ball(0.02), ball(0.6)}, 1)
          .closed_anew;
  ASSERT_TRUE(untied);
  EXPECT_FALSE(untied->is_the_same);
  EXPECT_EQ(untied->knot, "unknot");
  EXPECT_FALSE(certified_balls({ball(0.6), ball(0.5)}, 1).closed_anew) << "never buried";
}

TEST(Verify, a_knot_whose_end_is_buried_from_the_first_is_the_same_while_nothing_passes) {
  const CertifiedKnot knot = certified_balls({ball(0.02), ball(0.03)}, 1);
  EXPECT_EQ(knot.buried_since, 1);
  EXPECT_EQ(knot.buried_frames, 2);
  EXPECT_EQ(knot.uncertain_frames, 0);
}

TEST(Verify, a_knot_whose_end_is_buried_is_not_known_once_something_may_have_passed) {
  const CertifiedKnot knot =
      certified_balls({ball(0.6), ball(0.02), ball(0.02, 50), ball(0.02, 50)}, 1);
  EXPECT_EQ(knot.buried_frames, 1);
  EXPECT_EQ(knot.uncertain_frames, 2);
  ASSERT_TRUE(knot.may_have_passed);
  EXPECT_EQ(knot.may_have_passed->frame_before, 2);
  EXPECT_EQ(knot.may_have_passed->frame_after, 3);
  EXPECT_NEAR(knot.may_have_passed->moved_m, 2, 0.1);
}

// The centre line stays where it is, and the ribbon turns right through it.
TEST(Verify, a_twist_that_goes_while_the_end_is_buried_may_have_passed) {
  const CertifiedKnot knot = certified_balls({ball(0.6), ball(0.02), ball(0.02, 60, 1)}, 1);
  EXPECT_EQ(knot.buried_frames, 1);
  EXPECT_EQ(knot.uncertain_frames, 1);
  ASSERT_TRUE(knot.may_have_passed);
  EXPECT_EQ(knot.may_have_passed->frame_before, 2);
}

// Between the last certificate and the end's burial the closure alone would not be asked any more.
TEST(Verify, what_passed_just_before_an_end_got_buried_is_found) {
  const CertifiedKnot knot =
      certified_balls({ball(0.6, 60, 5), ball(0.6), ball(0.02), ball(0.02)}, 100);
  ASSERT_EQ(knot.changes.size(), 1U);
  EXPECT_EQ(knot.changes[0].frame_before, 1);
  EXPECT_EQ(knot.changes[0].frame_after, 2);
  EXPECT_LT(knot.changes[0].moved_m, 0.02) << "that of the next step belongs to the next change";
}

TEST(Verify, of_a_buried_end_after_a_broken_frame_nothing_is_known) {
  Eigen::Matrix3Xf broken = ball(0.02);
  broken(1, 7) = std::numeric_limits<float>::quiet_NaN();
  const CertifiedKnot knot = certified_balls({ball(0.6), ball(0.02), broken, ball(0.02)}, 1);
  EXPECT_EQ(knot.buried_frames, 1);
  EXPECT_EQ(knot.uncertain_frames, 2);
}

TEST(Verify, a_knot_that_is_expected_has_to_be_seen) {
  KnotCertifier knot({700, 2}, {}, {}, "unknot");
  int index = 0;
  for (const double hole_rad : {0.6, 0.02, 0.03}) knot.follow(index++, ball(hole_rad), true);
  const CertifiedKnot certified = knot.finish();
  EXPECT_EQ(certified.buried_frames, 0);
  EXPECT_EQ(certified.uncertain_frames, 2);
  EXPECT_EQ(certified.unexpected_frames, 2);
}

TEST(Verify, intersecting_frames_are_counted_and_the_worst_is_named) {
  const RecordingHeader header = sample_header();
  std::vector<Eigen::Matrix3Xd> frames(10, sample_positions(0));
  for (const std::size_t frame : {2U, 6U, 7U, 8U, 9U})
    frames[frame].row(1).array() -= 0.15;  // the tip of the stone comes through
  frames[5].row(1).array() -= 0.3;         // right through the middle
  const Verification verification = verify_frames(header, frames);
  EXPECT_EQ(
      verification.complaints(),
      (Complaints{"triangles intersect", "the stated gap is not kept", "the knot has changed"}));
  EXPECT_EQ(verification.intersecting_frames, 6);
  EXPECT_EQ(verification.most_intersections->frame, 6);
  EXPECT_GT(verification.intersecting_pairs, verification.most_intersections->pairs);
  ASSERT_EQ(verification.first_intersections.size(), 5U);
  EXPECT_EQ(verification.first_intersections[0].frame, 3);
  EXPECT_EQ(verification.first_intersections[0].time_s, 0.04);
  EXPECT_GE(verification.first_intersections[0].pair.second, header.grid.triangle_count());
  EXPECT_EQ(verification.smallest_gap->gap.certain_m, 0);
  EXPECT_EQ(verification.smallest_gap->frame, 3);
}

TEST(Verify, a_gap_below_the_stated_one_is_wrong) {
  RecordingHeader header = sample_header();
  std::vector<Eigen::Matrix3Xd> frames(3, sample_positions(0));
  frames[1].row(1).array() -= 0.095;  // 5 mm above the tip of the stone
  header.stated_gap_m = 0.0049;
  EXPECT_EQ(verify_frames(header, frames).complaints(), Complaints{});
  header.stated_gap_m = 0.0051;
  const Verification verification = verify_frames(header, frames);
  EXPECT_EQ(verification.complaints(), Complaints{"the stated gap is not kept"});
  EXPECT_EQ(verification.smallest_gap->frame, 2);
  EXPECT_NEAR(verification.smallest_gap->gap.certain_m, 0.005, 2e-5);
}

TEST(Verify, the_largest_strain_is_found_where_it_is) {
  std::vector<Eigen::Matrix3Xd> frames(4, sample_positions(0));
  frames[2](0, 239) += 1.0 / 39;  // a corner is pulled along by a row
  const Verification verification = verify_frames(sample_header(), frames);
  EXPECT_EQ(verification.complaints(), Complaints{"edges are strained beyond the limit"});
  EXPECT_EQ(verification.largest_strain->frame, 3);
  EXPECT_EQ(verification.largest_strain->strain.second, 239);
  EXPECT_NEAR(verification.largest_strain->strain.strain, 1, 1e-2);
}

// Only the diagonals of a ribbon that is sheared have other lengths.
TEST(Verify, strain_is_judged_on_the_limited_edges_alone) {
  RecordingHeader header = sample_header();
  std::vector<Eigen::Matrix3Xd> frames(3, sample_positions(0));
  for (int p = 0; p < header.grid.particle_count(); ++p)
    frames[1](0, p) += 0.1 * frames[1](2, p);  // one of the diagonals becomes longer by 4.95 %
  const auto largest = [&](const LimitedEdges& edges, double limit) {
    header.limited_edges = edges;
    header.strain_limit = limit;
    const Verification verification = verify_frames(header, frames);
    EXPECT_EQ(verification.keeps_strain_limit(), verification.complaints().empty());
    EXPECT_EQ(verification.complaints().empty(),
              limit == 0 || verification.largest_strain->strain.strain <= limit);
    return verification.largest_strain->strain.strain;
  };
  const LimitedEdges all{.along = true, .across = true, .diagonals = true};
  for (const double limit : {0.0, 0.045, 0.055}) {
    EXPECT_NEAR(largest(all, limit), 0.0495, 1e-3) << limit;
    EXPECT_NEAR(largest({.along = true}, limit), 0, 1e-3) << limit;
  }
}

TEST(Verify, a_recording_that_names_no_limited_edges_is_not_blamed_for_its_strain) {
  RecordingHeader header = sample_header();
  header.limited_edges = {};
  std::vector<Eigen::Matrix3Xd> frames(2, sample_positions(0));
  frames[1](0, 239) += 1.0 / 39;
  const Verification verification = verify_frames(header, frames);
  EXPECT_EQ(verification.complaints(), Complaints{});
  EXPECT_FALSE(verification.largest_strain.has_value());
}

// Neither frame intersects: only the knot tells.
TEST(Verify, a_strand_that_passed_through_another_between_two_frames_is_found) {
  RecordingHeader header = sample_header();
  header.grid = {80, 3};
  header.uv.setZero(2, header.grid.particle_count());
  header.obstacle.reset();
  header.ribbon_length_m = 40;
  header.strain_limit = 0;
  const Verification verification = verify_frames(
      header, {open_trefoil(header.grid, 1, 0.1), open_trefoil(header.grid, 0.5, 0.1),
               open_trefoil(header.grid, -0.5, 0.1), open_trefoil(header.grid, -1, 0.1)});
  EXPECT_EQ(verification.complaints(), Complaints{"the knot has changed"});
  ASSERT_EQ(verification.knot.changes.size(), 1U);
  const CertificateChange& change = verification.knot.changes.front();
  EXPECT_EQ(change.frame_before, 1);
  EXPECT_EQ(change.frame_after, 4);
  EXPECT_THAT(change.before, HasSubstr("trefoil"));
  EXPECT_NE(change.before, change.after);
}

RecordingHeader header_of_a_granny() {
  RecordingHeader header = sample_header();
  header.grid = {200, 2};
  header.uv.setZero(2, header.grid.particle_count());
  header.obstacle.reset();
  header.ribbon_length_m = 80;
  header.strain_limit = 0;
  header.limited_edges = {};
  return header;
}

// Two trefoils one after the other, the second the mirror image where `reef`.
Eigen::Matrix3Xd two_trefoils(bool reef) {
  const RibbonGrid half{100, 2};
  const Eigen::Matrix3Xd first = open_trefoil(half, 1, 0.1);
  Eigen::Matrix3Xd second = open_trefoil(half, reef ? -1 : 1, 0.1);
  const double shift = first(0, first.cols() - 1) - second(0, 0) + 0.2;
  second.row(0).array() += shift;
  Eigen::Matrix3Xd both(3, first.cols() + second.cols());
  both << first, second;
  return both;
}

Verification verify_part(const std::optional<KnotBetween>& stored,
                         const std::optional<std::array<double, 2>>& asked, bool reef) {
  RecordingHeader header = header_of_a_granny();
  header.knot_between = stored;
  const auto path = temporary_file("part.rbn");
  std::filesystem::remove(path);
  write_recording(path, header, {two_trefoils(reef), two_trefoils(reef)});
  auto reader = RecordingReader::open(path).value();
  return verify_recording(reader, {{0, 1}, 10, asked}, [](int) { return true; }).value();
}

TEST(Verify, a_part_that_the_recording_asks_for_is_certified_by_itself) {
  const Verification verification = verify_part(KnotBetween{{0.5, 0}, "trefoil"}, {}, false);
  EXPECT_EQ(verification.complaints(), Complaints{});
  EXPECT_THAT(verification.knot.certificate, HasSubstr("granny knot"));
  ASSERT_EQ(verification.parts.size(), 1U);
  EXPECT_EQ(verification.parts[0].rows, (RibbonPart{0, 100}));
  EXPECT_THAT(verification.parts[0].knot.certificate, StartsWith("trefoil, "));
  EXPECT_EQ(verification.parts[0].knot.certified_frames, 2);
}

TEST(Verify, a_part_that_is_another_knot_than_expected_is_wrong) {
  const auto complaints = [](const std::string& expected, bool reef) {
    return verify_part(KnotBetween{{0, 1}, expected}, {}, reef).complaints();
  };
  const Complaints wrong{"the knot of a part is not the one expected"};
  EXPECT_EQ(complaints("reef knot", true), Complaints{});
  EXPECT_EQ(complaints("square knot", true), Complaints{});
  EXPECT_EQ(complaints("reef knot", false), wrong);
  EXPECT_EQ(complaints("granny knot", true), wrong);
}

TEST(Verify, parts_that_are_asked_for_come_behind_that_of_the_recording) {
  const Verification verification =
      verify_part(KnotBetween{{0, 0.5}, ""}, std::array{0.25, 0.26}, true);
  EXPECT_EQ(verification.complaints(), Complaints{});
  ASSERT_EQ(verification.parts.size(), 2U);
  EXPECT_EQ(verification.parts[1].rows, (RibbonPart{50, 52}));
  EXPECT_THAT(verification.parts[1].knot.certificate, StartsWith("unknot"));
}

TEST(Verify, a_part_without_rows_is_refused) {
  auto reader = RecordingReader::open(sample(7)).value();
  const auto refusal = [&](double from, double to) {
    return refusal_of(
        verify_recording(reader, {{0}, 10, std::array{from, to}}, [](int) { return true; }));
  };
  EXPECT_THAT(refusal(0.5, 0.5), HasSubstr("no two rows lie between the places 0.5 and 0.5"));
  EXPECT_EQ(refusal(0.5, 0.55), "");
}

// Up along the axis, beyond the post's end, to the side and down again.
const std::vector<Pose> slipping_off{
    {}, {.height_m = 0.25}, {.height_m = 0.45}, {.height_m = 0.45, .x_m = 0.2}, {.x_m = 0.2}};

TEST(Verify, slipping_off_the_object_is_told_and_is_no_fault) {
  const Verification verification = verify_file(record_loops(header_with_post(), slipping_off));
  EXPECT_EQ(verification.complaints(), Complaints{});
  EXPECT_THAT(verification.knot.certificate, HasSubstr("1 turn round the object"));
  ASSERT_EQ(verification.passages_over_ends.size(), 1U);
  EXPECT_EQ(verification.passages_over_ends[0].frame, 4);
  EXPECT_EQ(verification.passages_over_ends[0].time_s, 0.06);
  EXPECT_EQ(verification.passages_over_ends[0].turns_before, 1);
  EXPECT_EQ(verification.passages_over_ends[0].turns_after, 0);
  ASSERT_TRUE(verification.outcome && verification.outcome->slipped_off);
  EXPECT_EQ(verification.outcome->slipped_off->frame, 3);
}

// No frame intersects: only the turns tell.
TEST(Verify, passing_through_the_object_between_two_frames_is_found) {
  const Verification verification =
      verify_file(record_loops(header_with_post(), {{}, {.x_m = 0.2}}));
  EXPECT_EQ(verification.complaints(), Complaints{"the knot has changed"});
  EXPECT_EQ(verification.passages_over_ends.size(), 0U);
}

TEST(Verify, without_an_object_no_turns_are_certified) {
  RecordingHeader header = header_with_post();
  header.obstacle.reset();
  const Verification verification = verify_file(record_loops(header, {{}, {.x_m = 0.2}}));
  EXPECT_EQ(verification.complaints(), Complaints{});
  EXPECT_THAT(verification.knot.certificate, Not(HasSubstr("turn")));
}

TEST(Verify, a_loop_that_moves_beside_the_object_is_no_fault) {
  const Verification verification =
      verify_file(record_loops(header_with_post(), {{.x_m = 0.2}, {.x_m = 0.3}}));
  EXPECT_EQ(verification.complaints(), Complaints{});
  EXPECT_FALSE(verification.outcome->embraces_object);
}

TEST(Verify, whoever_watches_can_stop_it) {
  auto reader = RecordingReader::open(sample(40)).value();
  std::vector<int> frames(40);
  std::iota(frames.begin(), frames.end(), 0);
  EXPECT_THAT(refusal_of(verify_recording(reader, {frames}, [](int done) { return done < 20; })),
              HasSubstr("interrupted after frame 32"));
}

}  // namespace ribbon::verify_recording_test
