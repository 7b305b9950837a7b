// The parts of the Python module, each of which adds functions and classes.
#pragma once

#include <pybind11/pybind11.h>

namespace rva::python {

/// Error and UsageError, to which the library's exceptions are translated.
void add_errors(pybind11::module_& module);

/// open(), info() and the class Capture.
void add_captures(pybind11::module_& module);

/// The classes Finding and Detection.
void add_detection(pybind11::module_& module);

/// detect().
void add_detect(pybind11::module_& module);

/// noise() and the class Noise.
void add_noise(pybind11::module_& module);

/// export().
void add_export(pybind11::module_& module);

/// calibrate().
void add_calibrate(pybind11::module_& module);

/// simulate().
void add_simulate(pybind11::module_& module);

}  // namespace rva::python
