// Writing a recording from Python.
#pragma once

#include <pybind11/pybind11.h>

namespace ribbon::python {

void bind_writer(pybind11::module_& module);

}  // namespace ribbon::python
