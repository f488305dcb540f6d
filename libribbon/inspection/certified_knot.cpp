#include "inspection/certified_knot.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

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
  watch(part_ ? part_->positions(grid_, positions) : positions);
  followed_ = index;
  if (certify_it || certified_ < 0) certify();
}

void KnotCertifier::watch(Eigen::Matrix3Xf positions) {
  witness_.follow(positions);
  if (known_) {
    const float moved_m = (positions - positions_).colwise().norm().maxCoeff();
    known_->moved_m = std::max(known_->moved_m, static_cast<double>(moved_m));
  }
  positions_ = std::move(positions);
}

void KnotCertifier::certify() {
  KnotCertificate certificate = witness_.certificate();
  if (certified_ < 0) result_.certificate = certificate.text();
  certified_ = followed_;
  ++result_.certified_frames;
  if (!expected_.empty() && !is_called(certificate, expected_)) ++result_.unexpected_frames;
  if (!certificate.is_known()) {
    ++result_.uncertain_frames;
    return;
  }
  if (known_ && certificate != known_->certificate) {
    CertificateChange change{known_->index + 1, followed_ + 1, known_->certificate.text(),
                             certificate.text(), known_->moved_m};
    if (turned_ends_explain(certificate)) {
      ++result_.uncertain_frames;
      if (!result_.turned_too_far) result_.turned_too_far = std::move(change);
      return;
    }
    result_.changes.push_back(std::move(change));
  }
  known_ = {followed_, std::move(certificate), witness_.wide_turns()};
}

// Both are known.
bool KnotCertifier::turned_ends_explain(const KnotCertificate& certificate) const {
  return certificate.equals_but_for_twist(known_->certificate) &&
         std::abs(*certificate.selvage_linking - *known_->certificate.selvage_linking) <=
             witness_.wide_turns() - known_->wide_turns;
}

CertifiedKnot KnotCertifier::finish() {
  if (followed_ > certified_) certify();
  return std::move(result_);
}

}  // namespace ribbon
