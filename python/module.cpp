// What the package ribbon of Python is built upon.
#include <pybind11/pybind11.h>

#include "python/mesh.h"
#include "python/recording.h"
#include "python/verification.h"
#include "python/writer.h"

PYBIND11_MODULE(_ribbon, module) {
  module.attr("__version__") = RIBBON_VERSION;
  ribbon::python::bind_mesh(module);
  ribbon::python::bind_recording(module);
  ribbon::python::bind_verification(module);
  ribbon::python::bind_writer(module);
}
