// Verification of frames and of whole recordings, as Python sees it.
#pragma once

#include <pybind11/pybind11.h>

namespace ribbon::python {

void bind_verification(pybind11::module_& module);

}  // namespace ribbon::python
