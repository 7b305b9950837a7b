#include <exception>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/options.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "keywords.hpp"
#include "module.hpp"

namespace rva::python {
namespace {

namespace py = pybind11;

// They last as long as the interpreter: a module that is a shared library is never unloaded.
PyObject* error_class = nullptr;
PyObject* usage_error_class = nullptr;

// @param sentence what the program prints, without its name
void raise(PyObject* kind, const std::string& sentence, const std::string& source, const Error& error) {
  const py::object value = py::reinterpret_borrow<py::object>(kind)(printable(sentence));
  value.attr("source") = source;
  value.attr("problem") = error.problem();
  value.attr("remedy") = error.remedy();
  PyErr_SetObject(kind, value.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(std::move(thrown));
  } catch (const OptionError& error) {
    const std::string name = keyword_name(error.source());
    raise(usage_error_class, Error(name, error.problem(), error.remedy()).what(), name, error);
  } catch (const UsageError& error) {
    raise(usage_error_class, error.what(), error.source(), error);
  } catch (const ExistsError& error) {
    raise(error_class, std::string(error.what()) + " with overwrite=True", error.source(), error);
  } catch (const Error& error) {
    raise(error_class, error.what(), error.source(), error);
  }
}

}  // namespace

void add_errors(py::module_& module) {
  error_class = PyErr_NewExceptionWithDoc(
      "rva.Error",
      "Something outside the program is wrong: a file, a device or the value of an option.\n\n"
      "Its text is the sentence that the program prints: 'source: problem; remedy'.",
      nullptr, nullptr);
  if (error_class == nullptr) throw py::error_already_set();
  usage_error_class = PyErr_NewExceptionWithDoc(
      "rva.UsageError", "An argument is out of range, or does not go with the others.", error_class, nullptr);
  if (usage_error_class == nullptr) throw py::error_already_set();
  module.attr("Error") = py::handle(error_class);
  module.attr("UsageError") = py::handle(usage_error_class);
  py::register_exception_translator(translate);
}

}  // namespace rva::python
