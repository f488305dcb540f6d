#include "python/arrays.h"

#include <string>
#include <string_view>

#include "recording/records/header_record.h"

namespace ribbon::python {

namespace {

std::string shape_text(const Shape& shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i)
    text += (i > 0 ? ", " : "") + (shape[i] < 0 ? "any" : std::to_string(shape[i]));
  return text + ")";
}

// kinds: letters of NumPy.
pybind11::array array_of(const char* what, const pybind11::object& given, std::string_view kinds,
                         const char* wanted) {
  auto array = pybind11::array::ensure(given);
  if (array && kinds.find(array.dtype().kind()) != std::string_view::npos) return array;
  const auto type = array ? pybind11::object(array.dtype()) : pybind11::type::of(given);
  throw pybind11::value_error(std::string(what) + " must be " + wanted + ", not of the type " +
                              std::string(pybind11::str(type)));
}

}  // namespace

bool has_shape(const pybind11::array& array, const Shape& shape) {
  if (array.ndim() != static_cast<pybind11::ssize_t>(shape.size())) return false;
  for (std::size_t i = 0; i < shape.size(); ++i)
    if (shape[i] >= 0 && array.shape(static_cast<pybind11::ssize_t>(i)) != shape[i]) return false;
  return true;
}

void require_shape(const char* what, const pybind11::array& array, const Shape& shape) {
  if (has_shape(array, shape)) return;
  throw pybind11::value_error(std::string(what) + " must have the shape " + shape_text(shape) +
                              ", not " +
                              shape_text(Shape(array.shape(), array.shape() + array.ndim())));
}

void require_recordable(const RibbonGrid& grid) {
  if (grid.along < 2 || grid.across < 2)
    throw pybind11::value_error("a ribbon has at least 2 x 2 particles");
  if (!is_recordable(grid))
    throw pybind11::value_error(
        "a ribbon has at most 2^24 particles in at most 2^20 columns, not " +
        std::to_string(grid.along) + " x " + std::to_string(grid.across));
}

pybind11::array numbers_of(const char* what, const pybind11::object& given) {
  return array_of(what, given, "fiu", "numbers");
}

pybind11::array whole_numbers_of(const char* what, const pybind11::object& given) {
  return array_of(what, given, "iu", "whole numbers");
}

Eigen::Matrix3Xd positions_of(const pybind11::object& given, const RibbonGrid& grid) {
  const Given<double> array = numbers_of("positions", given);
  require_shape("positions", array, shape_of(grid, 3));
  return Eigen::Matrix3Xd::Map(array.data(), 3, grid.particle_count());
}

}  // namespace ribbon::python
