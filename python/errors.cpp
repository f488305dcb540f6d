#include "python/errors.h"

#include <pybind11/pybind11.h>

#include "python/text.h"

namespace ribbon::python {

void raise(const Error& error) {
  const pybind11::object type = pybind11::module_::import("ribbon.errors").attr("Error");
  const pybind11::object exception =
      type(text_of(error.place), text_of(error.problem), text_of(error.remedy), error.may_pass);
  PyErr_SetObject(type.ptr(), exception.ptr());
  throw pybind11::error_already_set();
}

}  // namespace ribbon::python
