#include "python/mesh.h"

#include <cstdint>
#include <string>
#include <utility>

#include "geometry/triangle_mesh.h"
#include "python/arrays.h"
#include "python/text.h"

namespace py = pybind11;

namespace ribbon::python {

namespace {

using Corners = Eigen::Matrix<std::int64_t, 3, Eigen::Dynamic>;

TriangleMesh mesh_of(const py::object& given_vertices, const py::object& given_triangles,
                     std::string name) {
  const Given<float> vertices = numbers_of("vertices", given_vertices);
  const Given<std::int64_t> triangles = whole_numbers_of("triangles", given_triangles);
  require_shape("vertices", vertices, {-1, 3});
  require_shape("triangles", triangles, {-1, 3});
  const Eigen::Matrix3Xf places = Eigen::Matrix3Xf::Map(vertices.data(), 3, vertices.shape(0));
  if (!places.allFinite()) throw py::value_error("vertices must be finite numbers");
  const Eigen::Map<const Corners> corners(triangles.data(), 3, triangles.shape(0));
  if ((corners.array() < 0).any() || (corners.array() >= places.cols()).any())
    throw py::value_error("triangles must be numbers of vertices, from 0 to " +
                          std::to_string(places.cols() - 1));
  return {std::move(name), places, corners.cast<int>()};
}

py::str mesh_name(const TriangleMesh& mesh) {
  return text_of(mesh.name);
}

py::array mesh_vertices(const py::object& self) {
  const auto& mesh = self.cast<const TriangleMesh&>();
  return view_of(mesh.vertices, {mesh.vertices.cols(), 3}, self);
}

py::array mesh_triangles(const py::object& self) {
  const auto& mesh = self.cast<const TriangleMesh&>();
  return view_of(mesh.triangles, {mesh.triangles.cols(), 3}, self);
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::class_<TriangleMesh>(module, "Mesh", "Triangles over vertices; an obstacle.")
      .def(py::init(&mesh_of), py::arg("vertices"), py::arg("triangles"),
           py::arg("name") = "obstacle")
      .def_property_readonly("name", &mesh_name)
      .def_property_readonly("vertices", &mesh_vertices, "V x 3, metres, y up.")
      .def_property_readonly("triangles", &mesh_triangles,
                             "T x 3 numbers of vertices, counter-clockwise.");
}

}  // namespace ribbon::python
