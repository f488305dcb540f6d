#include "inspection/certified_knot.h"

#include <algorithm>
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
  if (part_)
    witness_.follow(part_->positions(grid_, positions));
  else
    witness_.follow(positions);
  followed_ = index;
  if (certify_it || certified_ < 0) certify();
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
  if (known_ && certificate != known_->certificate)
    result_.changes.push_back(
        {known_->index + 1, followed_ + 1, known_->certificate.text(), certificate.text()});
  known_ = {followed_, std::move(certificate)};
}

CertifiedKnot KnotCertifier::finish() {
  if (followed_ > certified_) certify();
  return std::move(result_);
}

}  // namespace ribbon
