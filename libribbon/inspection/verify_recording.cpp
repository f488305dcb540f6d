#include "inspection/verify_recording.h"

#include <algorithm>
#include <utility>

#include "parallel/parallel.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// Frames that are decoded one after the other and then verified at the same time.
constexpr int batch_frames = 16;
constexpr std::size_t most_examples = 5;

struct ReadFrame {
  int index = 0;
  Eigen::Matrix3Xf positions;
};

class RecordingVerifier {
 public:
  // The parts of the result are those to be certified.
  RecordingVerifier(RecordingReader& reader, const VerificationOrder& order,
                    std::vector<PartVerification> parts)
      : reader_(reader),
        order_(order),
        verifier_(rest_size(reader_.header()), reader.header().obstacle,
                  reader.header().limited_edges),
        knot_(reader.header().grid, std::nullopt,
              object_axis(reader.header().centre_axis, reader.header().obstacle), "") {
    for (const PartVerification& part : parts)
      parts_.emplace_back(reader.header().grid, part.rows, std::nullopt, part.expected);
    reader_.check();
    result_.header = reader.header();
    result_.parts = std::move(parts);
    result_.frames_asked = static_cast<int>(order.frames.size());
    result_.damaged = !reader.damage().empty();
    result_.outcome = outcome(reader);
  }

  void verify_batch(int begin, int end) {
    std::vector<ReadFrame> batch;
    for (int index = begin; index < end; ++index) {
      const bool is_asked = std::binary_search(order_.frames.begin(), order_.frames.end(), index);
      ReadFrame frame{index, {}};
      if (!reader_.read(index, frame.positions)) {
        if (is_asked) result_.lost.push_back(index + 1);
        continue;
      }
      follow(frame);
      if (is_asked) batch.push_back(std::move(frame));
    }
    std::vector<FrameVerdict> verdicts(batch.size());
    parallel_ranges(batch.size(), 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) verdicts[k] = verifier_.verify(batch[k].positions);
    });
    for (std::size_t k = 0; k < batch.size(); ++k) add(batch[k].index, verdicts[k]);
  }

  Verification finish() {
    result_.knot = knot_.finish();
    for (std::size_t k = 0; k < parts_.size(); ++k) result_.parts[k].knot = parts_[k].finish();
    return std::move(result_);
  }

 private:
  void follow(const ReadFrame& frame) {
    const auto& turns = knot_.witness().turns();
    const int over_ends_before = turns ? turns->turns_over_ends() : 0;
    const bool certify = (frame.index - order_.frames.front()) % order_.certify_every == 0;
    knot_.follow(frame.index, frame.positions, certify);
    for (KnotCertifier& part : parts_) part.follow(frame.index, frame.positions, certify);
    add_passage(frame.index, over_ends_before);
  }

  void add_passage(int index, int over_ends_before) {
    const auto& turns = knot_.witness().turns();
    if (!turns || turns->turns_over_ends() == over_ends_before) return;
    result_.passages_over_ends.push_back({index + 1, time_s(index),
                                          turns->turns() + over_ends_before,
                                          turns->turns() + turns->turns_over_ends()});
  }

  void add(int index, const FrameVerdict& verdict) {
    ++result_.frames_checked;
    const int frame = index + 1;
    if (!verdict.finite) {
      result_.not_finite.push_back(frame);
      return;
    }
    add_intersections(index, verdict.intersections);
    if (!result_.smallest_gap || verdict.gap.certain_m < result_.smallest_gap->gap.certain_m)
      result_.smallest_gap = {verdict.gap, frame};
    if (!result_.header.limited_edges.any()) return;
    if (!result_.largest_strain || verdict.strain.strain > result_.largest_strain->strain.strain)
      result_.largest_strain = {verdict.strain, frame};
  }

  void add_intersections(int index, const IntersectingPairs& found) {
    const std::size_t count = found.pairs.size();
    if (count == 0) return;
    result_.intersecting_pairs += count;
    result_.all_pairs_counted = result_.all_pairs_counted && found.all;
    ++result_.intersecting_frames;
    if (!result_.most_intersections || count > result_.most_intersections->pairs)
      result_.most_intersections = {count, index + 1};
    if (result_.first_intersections.size() < most_examples)
      result_.first_intersections.push_back({index + 1, time_s(index), found.pairs.front()});
  }

  [[nodiscard]] std::optional<double> time_s(int index) const {
    const auto numbers = reader_.numbers(index);
    return numbers ? std::optional(numbers->time_s) : std::nullopt;
  }

  RecordingReader& reader_;
  const VerificationOrder& order_;
  FrameVerifier verifier_;
  KnotCertifier knot_;
  std::vector<KnotCertifier> parts_;
  Verification result_;
};

Result<PartVerification> part_of(const RibbonGrid& grid, const KnotBetween& between) {
  const auto rows = part_between(grid, between.shares[0], between.shares[1]);
  if (rows) return PartVerification{*rows, between.expected, {}};
  return failure("",
                 filled_in("no two rows lie between the places {:.6g} and {:.6g} of the ribbon",
                           between.shares[0], between.shares[1]),
                 "name two places that are further apart");
}

Result<std::vector<PartVerification>> parts_of(const RecordingHeader& header,
                                               const VerificationOrder& order) {
  std::vector<KnotBetween> wanted;
  if (header.knot_between) wanted.push_back(*header.knot_between);
  if (order.between) wanted.push_back({*order.between, ""});
  std::vector<PartVerification> parts;
  for (const KnotBetween& between : wanted) {
    auto part = part_of(header.grid, between);
    if (!part) return tl::unexpected(part.error());
    parts.push_back(*std::move(part));
  }
  return parts;
}

}  // namespace

bool Verification::keeps_stated_gap() const {
  return !smallest_gap || smallest_gap->gap.certain_m >= header.stated_gap_m;
}

bool Verification::keeps_strain_limit() const {
  return header.strain_limit == 0 || !largest_strain ||
         largest_strain->strain.strain <= header.strain_limit;
}

std::vector<std::string> Verification::complaints() const {
  std::vector<std::string> list;
  const auto complain = [&](bool wrong, const char* what) {
    if (wrong) list.emplace_back(what);
  };
  complain(intersecting_pairs > 0, "triangles intersect");
  complain(!keeps_stated_gap(), "the stated gap is not kept");
  complain(!keeps_strain_limit(), "edges are strained beyond the limit");
  complain(!knot.changes.empty(), "the knot has changed");
  complain(knot.uncertain_frames > 0, "the knot cannot be certified");
  for (const PartVerification& part : parts) {
    complain(!part.knot.changes.empty(), "the knot of a part has changed");
    complain(part.knot.uncertain_frames > 0, "the knot of a part cannot be certified");
    complain(part.knot.unexpected_frames > 0, "the knot of a part is not the one expected");
  }
  complain(!not_finite.empty(), "coordinates are no numbers");
  complain(!lost.empty(), "frames are lost");
  complain(damaged && lost.empty(), "the file is damaged");
  return list;
}

Result<Verification> verify_recording(RecordingReader& reader, const VerificationOrder& order,
                                      const VerificationObserver& observer) {
  auto parts = parts_of(reader.header(), order);
  if (!parts) return tl::unexpected(parts.error());
  RecordingVerifier verifier(reader, order, *std::move(parts));
  const int first = order.frames.front();
  const int end = order.frames.back() + 1;
  for (int begin = first; begin < end; begin += batch_frames) {
    const int batch_end = std::min(begin + batch_frames, end);
    verifier.verify_batch(begin, batch_end);
    if (!observer(batch_end - first) && batch_end < end)
      return passing_failure("", filled_in("interrupted after frame {}", batch_end),
                             "run it again; --frames verifies a part");
  }
  return verifier.finish();
}

}  // namespace ribbon
