#include "inspect/inspection_folder.hpp"

#include <fmt/format.h>

#include "map/view_capture.hpp"

namespace rva {

InspectionFolder::InspectionFolder(const std::filesystem::path& data, std::int64_t id)
    : path_(data / "inspections" / fmt::format("{:06}", id)) {}

std::filesystem::path InspectionFolder::capture(Side side, const Inspection& inspection, int view,
                                                int dither) const {
  const int number = view * inspection.dither + dither;
  return this->side(side) / view_name(static_cast<std::size_t>(number));
}

std::filesystem::path InspectionFolder::result(int view) const {
  return path_ / "results" / view_name(static_cast<std::size_t>(view));
}

}  // namespace rva
