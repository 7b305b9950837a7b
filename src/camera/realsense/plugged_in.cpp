#include "camera/realsense/plugged_in.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace fs = std::filesystem;

namespace rva {
namespace {

std::string first_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

}  // namespace

std::vector<PluggedIn> plugged_in_realsense(const fs::path& devices) {
  constexpr const char* intel = "8086";
  std::vector<PluggedIn> found;
  std::error_code ignored;
  for (fs::directory_iterator device(devices, ignored), end; !ignored && device != end;
       device.increment(ignored)) {
    const std::string product = first_line(device->path() / "product");
    if (first_line(device->path() / "idVendor") != intel || product.find("RealSense") == std::string::npos)
      continue;
    found.push_back(
        {product, std::strtod(first_line(device->path() / "speed").c_str(), nullptr), device->path()});
  }
  std::ranges::sort(found, {}, &PluggedIn::product);
  return found;
}

}  // namespace rva
