// A triangle mesh as Python sees it.
#pragma once

#include <pybind11/pybind11.h>

namespace ribbon::python {

void bind_mesh(pybind11::module_& module);

}  // namespace ribbon::python
