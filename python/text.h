// Text of the outside world, as Python sees it.
#pragma once

#include <pybind11/pybind11.h>

#include <string_view>

namespace ribbon::python {

// Names of files and what a recording tells may be of any bytes; those that are no UTF-8 become
// "\xff", so that whoever prints the text can.
pybind11::str text_of(std::string_view bytes);

}  // namespace ribbon::python
