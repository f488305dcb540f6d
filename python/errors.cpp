#include "python/errors.h"

#include <pybind11/pybind11.h>

namespace ribbon::python {

void raise(const Error& error) {
  const pybind11::object type = pybind11::module_::import("ribbon.errors").attr("Error");
  const pybind11::object exception = type(error.place, error.problem, error.remedy, error.may_pass);
  PyErr_SetObject(type.ptr(), exception.ptr());
  throw pybind11::error_already_set();
}

}  // namespace ribbon::python
