#include "module.hpp"

PYBIND11_MODULE(rva, module) {
  namespace py = pybind11;
  using namespace rva::python;
  py::options options;
  options.disable_function_signatures();  // the descriptions begin with them (keywords.hpp)
  module.doc() = "RVA finds what was left behind: it compares depth images before and after the work.";
  module.attr("__version__") = RVA_VERSION;
  add_errors(module);
  add_captures(module);
  add_detection(module);
  add_detect(module);
  add_noise(module);
  add_export(module);
  add_calibrate(module);
  add_simulate(module);
}
