#include "images.hpp"

#include "core/error.hpp"

namespace rva::python {

void require_numpy() {
  try {
    pybind11::module_::import("numpy");
  } catch (const pybind11::error_already_set& error) {
    if (!error.matches(PyExc_ImportError)) throw;
    throw Error("numpy", "is not installed, and images are its arrays", "install the package python3-numpy");
  }
}

}  // namespace rva::python
