#include "evaluate/capture_room.hpp"

#include <unistd.h>

#include <cstdlib>
#include <string>
#include <system_error>

#include "core/error.hpp"

namespace fs = std::filesystem;

namespace rva {

CaptureRoom::CaptureRoom() {
  std::string name = fs::temp_directory_path() / "rva-evaluate-XXXXXX";
  if (::mkdtemp(name.data()) == nullptr)
    throw Error("captures", "cannot be stored in the folder for temporary files",
                "set TMPDIR to a writable folder");
  path_ = name;
}

CaptureRoom::~CaptureRoom() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace rva
