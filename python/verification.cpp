#include "python/verification.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "geometry/limited_edges.h"
#include "inspection/verify_recording.h"
#include "python/arrays.h"
#include "python/errors.h"
#include "python/recording.h"
#include "recording/records/header_record.h"
#include "verification/frame_verifier.h"

namespace py = pybind11;

namespace ribbon::python {

namespace {

// Knows the ribbon that it judges frames of.
class Verifier {
 public:
  Verifier(RestSize size, const std::optional<TriangleMesh>& obstacle, const LimitedEdges& limited)
      : grid_(size.grid), verifier_(std::move(size), obstacle, limited) {}

  // Other threads of Python go on meanwhile.
  [[nodiscard]] FrameVerdict verify(const py::object& positions) const {
    const Eigen::Matrix3Xf recorded = positions_of(positions, grid_).cast<float>();
    const py::gil_scoped_release others_run;
    return verifier_.verify(recorded);
  }

 private:
  RibbonGrid grid_;
  FrameVerifier verifier_;
};

Verifier verifier_of(const Recording& recording) {
  const RecordingHeader& header = recording.header();
  return {rest_size(header), header.obstacle, measured_edges(header.limited_edges)};
}

Verifier verifier_of_size(int along, int across, double length, double width,
                          const std::optional<TriangleMesh>& obstacle) {
  require_recordable({along, across});
  if (!is_positive(length) || !is_positive(width))
    throw py::value_error("length and width must be above 0, in metres");
  return {{{along, across}, length, width}, obstacle, all_edges};
}

py::array pairs_of(const FrameVerdict& verdict) {
  const std::vector<TrianglePair>& pairs = verdict.intersections.pairs;
  Eigen::Matrix2Xi numbers(2, std::ssize(pairs));
  for (Eigen::Index i = 0; i < numbers.cols(); ++i)
    numbers.col(i) << pairs[i].first, pairs[i].second;
  return owning_array(std::move(numbers), {std::ssize(pairs), 2});
}

std::vector<int> frames_to_verify(const Recording& recording,
                                  const std::optional<std::vector<int>>& asked) {
  std::vector<int> frames;
  if (asked)
    for (const int frame : *asked) frames.push_back(recording.index_of(frame));
  else
    for (int index = 0; index < recording.reader().frame_count(); ++index) frames.push_back(index);
  std::sort(frames.begin(), frames.end());
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  if (frames.empty()) throw py::value_error("there is no frame to verify");
  return frames;
}

// Ctrl-C stops it.
bool goes_on(int /*done*/) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  return true;
}

Verification verify(Recording& recording, const std::optional<std::vector<int>>& frames,
                    int certify_every) {
  if (certify_every < 1) throw py::value_error("certify_every must be at least 1");
  return value_of(verify_recording(
      recording.reader(),
      {.frames = frames_to_verify(recording, frames), .certify_every = certify_every}, goes_on));
}

std::optional<double> gap_of(const Verification& verification) {
  if (!verification.smallest_gap) return std::nullopt;
  return verification.smallest_gap->gap.certain_m;
}

std::optional<double> strain_of(const Verification& verification) {
  if (!verification.largest_strain) return std::nullopt;
  return verification.largest_strain->strain.strain;
}

// As Python counts, from 0.
std::vector<int> lost_frames(const Verification& verification) {
  std::vector<int> frames = verification.lost;
  for (int& frame : frames) --frame;
  return frames;
}

void bind_verifier(py::module_& module) {
  py::class_<FrameVerdict>(module, "FrameVerdict", "What was found in one frame.")
      .def_readonly("finite", &FrameVerdict::finite,
                    "False: a coordinate is no number, and nothing else is known.")
      .def_property_readonly("pairs", &pairs_of,
                             "P x 2 triangles that meet; the obstacle's follow the ribbon's.")
      .def_property_readonly(
          "intersects", [](const FrameVerdict& self) { return !self.intersections.pairs.empty(); })
      .def_property_readonly(
          "gap", [](const FrameVerdict& self) { return self.gap.certain_m; },
          "No gap is smaller, metres; 0 where triangles meet.")
      .def_property_readonly("strain", [](const FrameVerdict& self) { return self.strain.strain; });

  py::class_<Verifier>(module, "Verifier",
                       "Judges positions of one ribbon, wherever they come from.")
      .def(py::init(&verifier_of), py::arg("recording"))
      .def(py::init(&verifier_of_size), py::arg("along"), py::arg("across"), py::arg("length"),
           py::arg("width"), py::arg("obstacle") = py::none())
      .def("verify", &Verifier::verify, py::arg("positions"),
           "Judges positions of along x across x 3, in single precision as recordings keep them.");
}

}  // namespace

void bind_verification(py::module_& module) {
  bind_verifier(module);
  py::class_<Verification>(module, "Verification", "What ribbon-play --verify finds.")
      .def_property_readonly("complaints", &Verification::complaints,
                             "What is wrong; empty: nothing.")
      .def_readonly("frames_checked", &Verification::frames_checked)
      .def_property_readonly("lost", &lost_frames, "Frames that cannot be decoded.")
      .def_readonly("intersecting_pairs", &Verification::intersecting_pairs)
      .def_readonly("intersecting_frames", &Verification::intersecting_frames)
      .def_property_readonly("smallest_gap", &gap_of, "Metres, of all frames; None: none is known.")
      .def_property_readonly("largest_strain", &strain_of,
                             "Of the edges that are limited; None: none is.")
      .def_property_readonly("knot",
                             [](const Verification& self) { return self.knot.certificate; });
  module.def("verify", &verify, py::arg("recording"), py::arg("frames") = py::none(),
             py::arg("certify_every") = 10,
             "Verifies frames of a recording; all where none are named.");
}

}  // namespace ribbon::python
