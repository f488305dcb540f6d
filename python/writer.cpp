#include "python/writer.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "geometry/limited_edges.h"
#include "python/arrays.h"
#include "python/errors.h"
#include "recording/records/header_record.h"
#include "recording/writer/recording_writer.h"
#include "verification/largest_strain.h"

namespace py = pybind11;

namespace ribbon::python {

namespace {

// Of the ribbon's length, as in scenes.
constexpr double usual_error = 1e-5;
// Coordinates up to so many lengths are stored compactly, others as they are.
constexpr double usual_reach = 2;

// What Python says of a ribbon of its own.
struct OwnRibbon {
  RibbonGrid grid;
  double length_m;
  double width_m;
  double frames_per_second;
  std::string name;
  std::optional<TriangleMesh> obstacle;
  std::optional<double> max_error_m;
  double stated_gap_m;
  double strain_limit;
};

void require(bool is_so, const char* sentence) {
  if (!is_so) throw py::value_error(sentence);
}

void check(const OwnRibbon& own) {
  require_recordable(own.grid);
  require(is_positive(own.length_m) && is_positive(own.width_m),
          "length and width must be above 0, in metres");
  require(is_positive(own.frames_per_second), "frames_per_second must be above 0");
  require(!own.name.empty(), "name must not be empty");
  require(is_positive_or_zero(own.max_error_m.value_or(0)), "max_error must be at least 0");
  require(is_positive_or_zero(own.stated_gap_m), "stated_gap must be at least 0");
  require(is_positive_or_zero(own.strain_limit), "strain_limit must be at least 0");
}

// u along and v across, both from 0 to 1.
Eigen::Matrix2Xf even_uv(const RibbonGrid& grid) {
  Eigen::Matrix2Xf uv(2, grid.particle_count());
  for (int particle = 0; particle < grid.particle_count(); ++particle)
    uv.col(particle) << static_cast<float>(grid.row(particle)) / static_cast<float>(grid.along - 1),
        static_cast<float>(grid.column(particle)) / static_cast<float>(grid.across - 1);
  return uv;
}

RecordingHeader header_of(const OwnRibbon& own) {
  RecordingHeader header;
  header.scene_name = own.name;
  header.writer = "ribbon for Python " RIBBON_VERSION;
  header.grid = own.grid;
  header.uv = even_uv(own.grid);
  header.ribbon_length_m = own.length_m;
  header.ribbon_width_m = own.width_m;
  header.frames_per_second = own.frames_per_second;
  header.max_position_error_m = own.max_error_m.value_or(usual_error * own.length_m);
  header.quantisation_step_m =
      quantisation_step_m(header.max_position_error_m, usual_reach * own.length_m);
  header.obstacle = own.obstacle;
  header.stated_gap_m = own.stated_gap_m;
  header.strain_limit = own.strain_limit;
  if (own.strain_limit > 0) header.limited_edges = all_edges;
  return header;
}

class Writer {
 public:
  Writer(const std::filesystem::path& path, const OwnRibbon& own, bool force)
      : writer_(value_of(RecordingWriter::create(path, header_of(own),
                                                 force ? Overwrite::yes : Overwrite::no))) {}
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { abandon(); }

  // Times follow one another at the rate of frames unless they are told.
  void append(const py::object& given, std::optional<double> time_s) {
    const RecordingHeader& header = open_writer().header();
    const Eigen::Matrix3Xd positions = positions_of(given, header.grid);
    if (!positions.allFinite())
      throw py::value_error("positions of frame " + std::to_string(writer_->frames_written() + 1) +
                            " must be finite numbers");
    FrameNumbers numbers;
    numbers.time_s = time_s.value_or(writer_->frames_written() / header.frames_per_second);
    check_follows(numbers.time_s);
    numbers.worst_strain =
        largest_strain(rest_size(header), all_edges, positions.cast<float>()).strain;
    value_of(writer_->append(numbers, positions));
    last_time_s_ = numbers.time_s;
  }

  [[nodiscard]] int frame_count() { return static_cast<int>(open_writer().frames_written()); }

  void finish() {
    if (!writer_) return;
    RecordingWriter writer = *std::move(writer_);
    writer_.reset();
    value_of(writer.finish());
  }

  // The recording stays as it is, readable but not finished; without a frame it is of no use, and
  // the name is free again.
  void abandon() {
    if (writer_ && writer_->frames_written() == 0) writer_->take_back();
    writer_.reset();
  }

 private:
  RecordingWriter& open_writer() {
    if (!writer_) throw py::value_error("the recording is closed");
    return *writer_;
  }

  void check_follows(double time_s) const {
    if (std::isfinite(time_s) && time_s > last_time_s_) return;
    const py::str sentence(writer_->frames_written() == 0
                               ? "the time of frame {}, {} s, must be a number"
                               : "the time of frame {}, {} s, must be later than {} s, that of the "
                                 "frame before");
    throw py::value_error(
        std::string(py::str(sentence.format(writer_->frames_written() + 1, time_s, last_time_s_))));
  }

  std::optional<RecordingWriter> writer_;
  double last_time_s_ = -std::numeric_limits<double>::infinity();
};

std::unique_ptr<Writer> new_writer(const std::filesystem::path& path, int along, int across,
                                   double length, double width, double frames_per_second,
                                   std::optional<TriangleMesh> obstacle, std::string name,
                                   std::optional<double> max_error, double stated_gap,
                                   double strain_limit, bool force) {
  const OwnRibbon own{{along, across},   length,          width,
                      frames_per_second, std::move(name), std::move(obstacle),
                      max_error,         stated_gap,      strain_limit};
  check(own);
  return std::make_unique<Writer>(path, own, force);
}

}  // namespace

void bind_writer(py::module_& module) {
  py::class_<Writer>(module, "Writer", "Writes frames of a ribbon of one's own as a recording.")
      .def(py::init(&new_writer), py::arg("path"), py::kw_only(), py::arg("along"),
           py::arg("across"), py::arg("length"), py::arg("width"),
           py::arg("frames_per_second") = 50.0, py::arg("obstacle") = py::none(),
           py::arg("name") = "python", py::arg("max_error") = py::none(),
           py::arg("stated_gap") = 0.0, py::arg("strain_limit") = 0.0, py::arg("force") = false)
      .def("append", &Writer::append, py::arg("positions"), py::arg("time") = py::none(),
           "Writes the next frame: positions of along x across x 3, metres, y up.")
      .def("__len__", &Writer::frame_count)
      .def("close", &Writer::finish, "Finishes the recording.")
      .def("__enter__", [](py::object self) { return self; })
      .def("__exit__",
           [](Writer& self, const py::object& type, const py::object&, const py::object&) {
             if (type.is_none())
               self.finish();
             else
               self.abandon();
           });
}

}  // namespace ribbon::python
