// Images as arrays of numpy that show the library's own pixels: nothing is copied, and nothing can be
// written.
#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "depth/image.hpp"

namespace rva::python {

/// @throws Error when numpy is not installed
void require_numpy();

/// An array that cannot be written. @param owner the object that has the pixels, which the array keeps alive
template <typename Pixel>
pybind11::array read_only(pybind11::array::ShapeContainer shape, const Pixel* pixels,
                          pybind11::handle owner) {
  pybind11::array_t<Pixel> array(std::move(shape), pixels, owner);
  array.attr("setflags")(pybind11::arg("write") = false);
  return array;
}

/// An array of height x width pixels. @param owner as of read_only()
template <typename Pixel, typename Meaning>
pybind11::array view_of(const Image<Pixel, Meaning>& image, pybind11::handle owner) {
  require_numpy();
  return read_only<Pixel>({image.height(), image.width()}, image.data(), owner);
}

/// An array of height x width x 3 values: red, green, blue. @param owner as of read_only()
inline pybind11::array view_of(const ColorImage& image, pybind11::handle owner) {
  static_assert(sizeof(Rgb) == 3);
  require_numpy();
  return read_only<std::uint8_t>({image.height(), image.width(), 3}, &image.data()->r, owner);
}

/// An array that owns the image.
template <typename Image>
pybind11::array array_of(Image image) {
  auto owned = std::make_unique<Image>(std::move(image));
  const pybind11::capsule owner(owned.get(), [](void* pixels) { delete static_cast<Image*>(pixels); });
  return view_of(*owned.release(), owner);
}

/// None where there is no image.
template <typename Image>
pybind11::object array_of(std::optional<Image> image) {
  return image ? pybind11::object(array_of(std::move(*image))) : pybind11::none();
}

}  // namespace rva::python
