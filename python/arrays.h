// Matrices as NumPy arrays. Ours lie column by column, NumPy's row by row: a matrix of 3 x N is an
// array of N x 3, of the same numbers at the same places.
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/ribbon_grid.h"

namespace ribbon::python {

using Shape = std::vector<pybind11::ssize_t>;

// Other kinds of numbers are converted, other orders copied.
template <class Number>
using Given = pybind11::array_t<Number, pybind11::array::c_style | pybind11::array::forcecast>;

inline Shape shape_of(const RibbonGrid& grid, int components) {
  return {grid.along, grid.across, components};
}

// An array that owns the numbers of `matrix`, which are not copied.
template <class Matrix>
pybind11::array owning_array(Matrix matrix, Shape shape) {
  auto kept = std::make_unique<Matrix>(std::move(matrix));
  typename Matrix::Scalar* numbers = kept->data();
  const pybind11::capsule owner(kept.get(), [](void* it) { delete static_cast<Matrix*>(it); });
  static_cast<void>(kept.release());
  return pybind11::array_t<typename Matrix::Scalar>(std::move(shape), numbers, owner);
}

// An array that cannot be written to and shows the numbers of a matrix in `owner`, which stays
// alive as long as the array does.
template <class Matrix>
pybind11::array view_of(const Matrix& matrix, Shape shape, const pybind11::object& owner) {
  pybind11::array_t<typename Matrix::Scalar> array(std::move(shape), matrix.data(), owner);
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

// Has the array this shape? -1 stands for any length.
bool has_shape(const pybind11::array& array, const Shape& shape);

// ValueError "positions must have the shape (400, 8, 3), not (8, 400, 3)" unless it has.
void require_shape(const char* what, const pybind11::array& array, const Shape& shape);

// ValueError unless a recording may have this grid: its particles can then be counted.
void require_recordable(const RibbonGrid& grid);

// What the caller hands over as an array of numbers, of whole ones; ValueError where it is none.
// Nothing that only looks like numbers is taken: texts, or complex numbers, which lose a part.
pybind11::array numbers_of(const char* what, const pybind11::object& given);
pybind11::array whole_numbers_of(const char* what, const pybind11::object& given);

// 3 x particles, of an array of along x across x 3; what is wrong with that is a ValueError.
Eigen::Matrix3Xd positions_of(const pybind11::object& given, const RibbonGrid& grid);

}  // namespace ribbon::python
