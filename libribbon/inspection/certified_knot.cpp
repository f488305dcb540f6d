#include "inspection/certified_knot.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "knot/type/knot_names.h"
#include "knot/type/tied_forms.h"

namespace ribbon {

namespace {

bool is_called(const KnotCertificate& certificate, const std::string& name) {
  if (!certificate.jones) return false;
  const auto names = names_of_type(*certificate.jones);
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

KnotCertifier::KnotCertifier(const RibbonGrid& grid, std::optional<RibbonPart> part,
                             const std::optional<ObjectAxis>& axis, std::string expected)
    : grid_(grid),
      part_(part),
      witness_(part ? part->grid(grid) : grid, axis),
      expected_(std::move(expected)) {}

void KnotCertifier::follow(int index, const Eigen::Matrix3Xf& positions, bool certify_it) {
  watch(index, part_ ? part_->positions(grid_, positions) : positions);
  followed_ = index;
  if (certify_it || certified_ < 0) certify(index, witness_.certificate());
}

void KnotCertifier::watch(int index, Eigen::Matrix3Xf positions) {
  witness_.follow(positions);
  const double moved_m =
      followed_ < 0 ? 0 : static_cast<double>((positions - positions_).colwise().norm().maxCoeff());
  if (witness_.is_buried() && !result_.buried_since) {
    result_.buried_since = index + 1;
    if (witness_.last_closed()) {
      last_closed_ = followed_;
      if (certified_ < followed_) certify(followed_, *witness_.last_closed());
    }
  }
  if (known_) known_->moved_m = std::max(known_->moved_m, moved_m);
  if (witness_.may_have_passed() && !result_.may_have_passed)
    result_.may_have_passed = {followed_ + 1, index + 1, moved_m};
  positions_ = std::move(positions);
}

// Is it known, or carried on from the last that was, or from a first frame that is not known at
// all? What is expected has to be seen.
bool KnotCertifier::tells_the_knot(const KnotCertificate& certificate) const {
  if (certificate.is_known()) return true;
  const bool closed_is_known = !last_closed_ || (known_ && known_->index >= *last_closed_);
  return certificate.is_carried_on() && closed_is_known && expected_.empty();
}

void KnotCertifier::certify(int index, KnotCertificate certificate) {
  if (certified_ < 0) result_.certificate = certificate.text();
  certified_ = index;
  ++result_.certified_frames;
  if (!expected_.empty() && !is_called(certificate, expected_)) ++result_.unexpected_frames;
  if (!tells_the_knot(certificate)) {
    ++result_.uncertain_frames;
    return;
  }
  if (!certificate.is_known()) ++result_.buried_frames;
  if (known_ && certificate.contradicts(known_->certificate)) {
    CertificateChange change{known_->index + 1, index + 1, known_->certificate.text(),
                             certificate.text(), known_->moved_m};
    if (turned_ends_explain(certificate)) {
      ++result_.uncertain_frames;
      if (!result_.turned_too_far) result_.turned_too_far = std::move(change);
      return;
    }
    result_.changes.push_back(std::move(change));
  }
  known_ = {index, std::move(certificate), witness_.wide_turns()};
}

// They contradict each other.
bool KnotCertifier::turned_ends_explain(const KnotCertificate& certificate) const {
  return certificate.is_known() && certificate.equals_but_for_twist(known_->certificate) &&
         std::abs(*certificate.selvage_linking - *known_->certificate.selvage_linking) <=
             witness_.wide_turns() - known_->wide_turns;
}

// An end that is drawn back out of a loop unties a knot, though nothing passes through anything.
std::optional<ClosedAnew> KnotCertifier::closed_anew() const {
  const std::optional<KnotCertificate>& closed = witness_.last_closed();
  if (!closed || !closed->jones) return std::nullopt;
  KnotWitness witness(part_ ? part_->grid(grid_) : grid_, std::nullopt);
  witness.follow(positions_);
  const auto type = witness.certificate().jones;
  if (!type) return std::nullopt;
  return ClosedAnew{knot_text(*type), *type == *closed->jones};
}

CertifiedKnot KnotCertifier::finish() {
  if (followed_ > certified_) certify(followed_, witness_.certificate());
  result_.closed_anew = closed_anew();
  return std::move(result_);
}

}  // namespace ribbon
