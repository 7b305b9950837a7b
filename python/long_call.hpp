// Long work without the interpreter's lock, so that other threads of Python run meanwhile.
#pragma once

#include <pybind11/pybind11.h>

#include <string_view>

#include "core/progress.hpp"

namespace rva::python {

/// What an argument `progress` is, for describe_keywords().
inline constexpr const char* progress_sentence =
    "a function of step, done and total that is called as the work proceeds; its exception ends the work";

/// Returns what `work` returns, which it does without the interpreter's lock: it must not touch Python
/// objects.
template <typename Work>
auto without_lock(const Work& work) {
  const pybind11::gil_scoped_release released;
  return work();
}

/// Progress for work without the lock. At each step, Ctrl-C ends the work with KeyboardInterrupt.
/// @param callback None, or a function of step, done and total, whose exception ends the work; it must
/// outlive
///                 the result
[[nodiscard]] inline Progress progress_to(pybind11::handle callback) {
  return [callback](std::string_view step, std::size_t done, std::size_t total) {
    const pybind11::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    if (!callback.is_none()) callback(step, done, total);
  };
}

}  // namespace rva::python
