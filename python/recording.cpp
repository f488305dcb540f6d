#include "python/recording.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "python/arrays.h"
#include "python/errors.h"
#include "python/text.h"

namespace py = pybind11;

namespace ribbon::python {

namespace {

using NumberOf = std::function<double(const FrameNumbers&)>;

struct NumberColumn {
  const char* name;
  NumberOf number;
};

std::vector<NumberColumn> number_columns() {
  std::vector<NumberColumn> columns = {
      {"time", [](const FrameNumbers& numbers) { return numbers.time_s; }},
      {"worst_strain", [](const FrameNumbers& numbers) { return numbers.worst_strain; }},
      {"penetrating_edges", [](const FrameNumbers& numbers) { return numbers.penetrating_edges; }},
      {"recovery_iterations",
       [](const FrameNumbers& numbers) { return numbers.recovery_iterations; }},
      {"stage", [](const FrameNumbers& numbers) { return numbers.stage; }}};
  for (const TightnessColumn& column : tightness_columns)
    columns.push_back({column.name, [value = column.value](const FrameNumbers& numbers) {
                         return numbers.tightness ? static_cast<double>(*numbers.tightness.*value)
                                                  : std::numeric_limits<double>::quiet_NaN();
                       }});
  return columns;
}

Eigen::VectorXd over_time(const RecordingReader& reader, const NumberOf& number) {
  Eigen::VectorXd column(reader.frame_count());
  for (int index = 0; index < reader.frame_count(); ++index) {
    const auto numbers = reader.numbers(index);
    column[index] = numbers ? number(*numbers) : std::numeric_limits<double>::quiet_NaN();
  }
  return column;
}

// (byte, length, reason) of each part of the file that cannot be read.
auto damage_of(const Recording& recording) {
  std::vector<std::tuple<std::uint64_t, std::uint64_t, py::str>> parts;
  for (const Damage& damage : recording.reader().damage())
    parts.emplace_back(damage.byte, damage.length, text_of(damage.reason));
  return parts;
}

py::array row_widths(const Recording& recording) {
  const RestSize size = rest_size(recording.header());
  Eigen::VectorXd widths_m(size.grid.along);
  for (int row = 0; row < size.grid.along; ++row) widths_m[row] = size.row_width_m(row);
  return owning_array(std::move(widths_m), {size.grid.along});
}

py::array ribbon_triangles(const Recording& recording) {
  const RibbonGrid& grid = recording.header().grid;
  return owning_array(grid.triangles(), {grid.triangle_count(), 3});
}

py::array uv(const py::object& self) {
  const RecordingHeader& header = self.cast<const Recording&>().header();
  return view_of(header.uv, shape_of(header.grid, 2), self);
}

py::array input_curve(const py::object& self) {
  const RecordingHeader& header = self.cast<const Recording&>().header();
  return view_of(header.input_curve, {header.input_curve.cols(), 3}, self);
}

py::object obstacle(const py::object& self) {
  const RecordingHeader& header = self.cast<const Recording&>().header();
  if (!header.obstacle) return py::none();
  return py::cast(&*header.obstacle, py::return_value_policy::reference_internal, self);
}

py::dict marks(const Recording& recording) {
  py::dict shares;
  for (const RecordedMark& mark : recording.header().marks) shares[text_of(mark.name)] = mark.share;
  return shares;
}

// A property that is what the header has there.
template <class Value>
auto of_header(Value RecordingHeader::*member) {
  return [member](const Recording& self) { return self.header().*member; };
}

auto text_of_header(std::string RecordingHeader::*member) {
  return [member](const Recording& self) { return text_of(self.header().*member); };
}

py::list stages(const Recording& recording) {
  py::list names;
  for (const std::string& stage : recording.header().stages) names.append(text_of(stage));
  return names;
}

// A property that the reader is asked for.
template <class Answer>
auto of_reader(Answer (RecordingReader::*question)() const) {
  return [question](const Recording& self) { return (self.reader().*question)(); };
}

bool is_readable(const Recording& self, int frame) {
  return self.reader().readable(self.index_of(frame));
}

void bind_frames(py::class_<Recording>& recording) {
  recording.def(py::init<const std::filesystem::path&>(), py::arg("path"))
      .def("__len__", of_reader(&RecordingReader::frame_count))
      .def("__getitem__", &Recording::positions, py::arg("frame"),
           "Positions of a frame: along x across x 3, single precision, metres, y up.")
      .def("numbers", &Recording::numbers,
           "Name -> array over all frames; not a number where a frame has none.")
      .def("readable", &is_readable, py::arg("frame"),
           "Can the frame be decoded? Damage may have taken it, as far as is known: check() looks.")
      .def(
          "check", [](Recording& self) { self.reader().check(); },
          "Reads the whole file once, so that readable(), numbers() and damage tell all.")
      .def("refresh", &Recording::refresh, "Looks for new frames; tells how many there are now.");
}

void bind_state(py::class_<Recording>& recording) {
  recording
      .def_property_readonly("being_written", of_reader(&RecordingReader::is_being_written),
                             "Is a writer at it at this moment?")
      .def_property_readonly("finished", of_reader(&RecordingReader::finished))
      .def_property_readonly(
          "ending", [](const Recording& self) { return word_for(self.reader().ending()); },
          "What ended the run: 'tight', 'duration', ...; 'unknown' where that is not told.")
      .def_property_readonly(
          "damage", &damage_of,
          "(byte, length, reason) of each part that cannot be read, as far as is known: "
          "check() looks.");
}

void bind_ribbon(py::class_<Recording>& recording) {
  recording
      .def_property_readonly("along",
                             [](const Recording& self) { return self.header().grid.along; })
      .def_property_readonly("across",
                             [](const Recording& self) { return self.header().grid.across; })
      .def_property_readonly("length", of_header(&RecordingHeader::ribbon_length_m), "Metres.")
      .def_property_readonly("width", of_header(&RecordingHeader::ribbon_width_m),
                             "Metres, the mean of all rows.")
      .def_property_readonly("row_widths", &row_widths, "Width of each row at rest, metres.")
      .def_property_readonly("triangles", &ribbon_triangles,
                             "T x 3 numbers of particles, row by row from 0.")
      .def_property_readonly("uv", &uv, "along x across x 2, from 0 to 1.")
      .def_property_readonly("obstacle", &obstacle, "A Mesh, or None.")
      .def_property_readonly("input_curve", &input_curve,
                             "P x 3: the drawing in space; empty if not told.");
}

void bind_scene(py::class_<Recording>& recording) {
  recording
      .def_property_readonly("frames_per_second", of_header(&RecordingHeader::frames_per_second))
      .def_property_readonly(
          "max_error", of_header(&RecordingHeader::max_position_error_m),
          "How far a coordinate may be from the truth, metres; 0: single precision.")
      .def_property_readonly("stated_gap", of_header(&RecordingHeader::stated_gap_m),
                             "No two features come nearer, metres; 0: nothing is stated.")
      .def_property_readonly("strain_limit", of_header(&RecordingHeader::strain_limit),
                             "No limited edge is strained further; 0: nothing is stated.")
      .def_property_readonly("scene_name", text_of_header(&RecordingHeader::scene_name))
      .def_property_readonly("scene_text", text_of_header(&RecordingHeader::scene_text), "TOML.")
      .def_property_readonly("writer", text_of_header(&RecordingHeader::writer),
                             "Program and version.")
      .def_property_readonly("stages", &stages)
      .def_property_readonly("marks", &marks,
                             "Name -> share of the length, of the drawing's marks.");
}

}  // namespace

Recording::Recording(const std::filesystem::path& path)
    : reader_(value_of(RecordingReader::open(path))) {}

int Recording::index_of(int frame) const {
  const int count = reader_.frame_count();
  if (frame < -count || frame >= count)
    throw py::index_error("there is no frame " + std::to_string(frame) + ", only " +
                          std::to_string(count) + " from 0");
  return frame < 0 ? frame + count : frame;
}

py::array Recording::positions(int frame) {
  Eigen::Matrix3Xf positions;
  value_of(reader_.read(index_of(frame), positions));
  return owning_array(std::move(positions), shape_of(header().grid, 3));
}

py::dict Recording::numbers() const {
  py::dict arrays;
  for (const NumberColumn& column : number_columns())
    arrays[column.name] = owning_array(over_time(reader_, column.number), {reader_.frame_count()});
  return arrays;
}

int Recording::refresh() {
  value_of(reader_.refresh());
  return reader_.frame_count();
}

void bind_recording(py::module_& module) {
  py::class_<Recording> recording(module, "Recording",
                                  "A recording, any frame at any time, also while it is written.");
  bind_frames(recording);
  bind_state(recording);
  bind_ribbon(recording);
  bind_scene(recording);
}

}  // namespace ribbon::python
