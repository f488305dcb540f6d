#include "inspection/verify_recording.h"

#include <algorithm>
#include <utility>

#include "knot/knot_witness.h"
#include "parallel/parallel.h"
#include "text/number_text.h"

namespace ribbon {

namespace {

// Frames that are decoded one after the other and then verified at the same time.
constexpr int batch_frames = 16;
constexpr std::size_t most_examples = 5;

struct DecodedFrame {
  int index = 0;
  Eigen::Matrix3Xf positions;
};

class RecordingVerifier {
 public:
  RecordingVerifier(RecordingReader& reader, const std::vector<int>& asked, int certify_every)
      : reader_(reader),
        asked_(asked),
        certify_every_(certify_every),
        verifier_(reader.header().grid, reader.header().ribbon_length_m,
                  reader.header().ribbon_width_m, reader.header().obstacle,
                  reader.header().limited_edges),
        witness_(reader.header().grid,
                 object_axis(reader.header().centre_axis, reader.header().obstacle)) {
    reader_.check();
    result_.header = reader.header();
    result_.frames_asked = static_cast<int>(asked.size());
    result_.damaged = !reader.damage().empty();
    result_.outcome = outcome(reader);
  }

  void verify_batch(int begin, int end) {
    std::vector<DecodedFrame> batch;
    for (int index = begin; index < end; ++index) {
      const bool is_asked = std::binary_search(asked_.begin(), asked_.end(), index);
      DecodedFrame frame{index, {}};
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
    // The last frame that could be read.
    if (followed_ > certified_) certify();
    return std::move(result_);
  }

 private:
  void follow(const DecodedFrame& frame) {
    const int over_ends_before = witness_.turns() ? witness_.turns()->turns_over_ends() : 0;
    witness_.follow(frame.positions);
    add_passage(frame.index, over_ends_before);
    followed_ = frame.index;
    if (certified_ < 0 || (frame.index - asked_.front()) % certify_every_ == 0) certify();
  }

  void add_passage(int index, int over_ends_before) {
    const auto& turns = witness_.turns();
    if (!turns || turns->turns_over_ends() == over_ends_before) return;
    result_.passages_over_ends.push_back({index + 1, time_s(index),
                                          turns->turns() + over_ends_before,
                                          turns->turns() + turns->turns_over_ends()});
  }

  void certify() {
    KnotCertificate certificate = witness_.certificate();
    if (certified_ < 0)
      result_.certificate = certificate.text();
    else if (certificate != certificate_)
      result_.certificate_changes.push_back(
          {certified_ + 1, followed_ + 1, certificate_.text(), certificate.text()});
    certificate_ = std::move(certificate);
    certified_ = followed_;
    ++result_.certified_frames;
    if (!certificate_.is_known()) ++result_.uncertain_frames;
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
  const std::vector<int>& asked_;
  int certify_every_;
  FrameVerifier verifier_;
  KnotWitness witness_;
  int followed_ = -1;            // index of the frame followed last
  int certified_ = -1;           // and of the one certified last,
  KnotCertificate certificate_;  // with its certificate
  Verification result_;
};

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
  complain(!certificate_changes.empty(), "the knot has changed");
  complain(uncertain_frames > 0, "the knot cannot be certified");
  complain(!not_finite.empty(), "coordinates are no numbers");
  complain(!lost.empty(), "frames are lost");
  complain(damaged && lost.empty(), "the file is damaged");
  return list;
}

Result<Verification> verify_recording(RecordingReader& reader, const std::vector<int>& asked,
                                      int certify_every, const VerificationObserver& observer) {
  RecordingVerifier verifier(reader, asked, certify_every);
  const int end = asked.back() + 1;
  for (int begin = asked.front(); begin < end; begin += batch_frames) {
    const int batch_end = std::min(begin + batch_frames, end);
    verifier.verify_batch(begin, batch_end);
    if (!observer(batch_end - asked.front()) && batch_end < end)
      return passing_failure("", filled_in("interrupted after frame {}", batch_end),
                             "run it again; --frames verifies a part");
  }
  return verifier.finish();
}

}  // namespace ribbon
