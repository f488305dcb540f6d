#include "python/mesh.h"

#include <string>
#include <utility>

#include "geometry/triangle_mesh.h"
#include "python/arrays.h"
#include "python/text.h"

namespace py = pybind11;

namespace ribbon::python {

namespace {

TriangleMesh mesh_of(const Given<float>& vertices, const Given<int>& triangles, std::string name) {
  require_shape("vertices", vertices, {-1, 3});
  require_shape("triangles", triangles, {-1, 3});
  TriangleMesh mesh{std::move(name), Eigen::Matrix3Xf::Map(vertices.data(), 3, vertices.shape(0)),
                    Eigen::Matrix3Xi::Map(triangles.data(), 3, triangles.shape(0))};
  if (!mesh.vertices.allFinite()) throw py::value_error("vertices must be finite numbers");
  const auto corners = mesh.triangles.array();
  const auto count = static_cast<int>(mesh.vertices.cols());
  if ((corners < 0).any() || (corners >= count).any())
    throw py::value_error("triangles must be numbers of vertices, from 0 to " +
                          std::to_string(count - 1));
  return mesh;
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
