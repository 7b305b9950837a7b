#include "detect/genuine_captures.hpp"

#include <algorithm>
#include <system_error>
#include <vector>

#include "capture/frozen.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr const char* give_once = "give each capture once";
constexpr const char* take_both = "take one capture before the work and another one after it";

/// The path of a capture of either side.
struct GivenPath {
  const std::filesystem::path& path;
  bool initial = false;
};

/// A capture of either side.
struct Given {
  const Capture& capture;
  std::size_t frames = 0;  ///< that are used
  bool initial = false;
  DepthImage first;
};

// Calls `use` with every two that are given.
void for_each_pair(const auto& all, auto&& use) {
  for (std::size_t b = 1; b < all.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) use(all[a], all[b]);
  }
}

// Decodes the first frame of each capture once, for all pairs.
std::vector<Given> given(const Captures& initial, const Captures& final, std::size_t frames) {
  std::vector<Given> all;
  for (const Captures* side : {&initial, &final}) {
    for (const auto& capture : *side) {
      const std::size_t available = capture->depth_frames();
      all.push_back({*capture, frames == 0 ? available : std::min(frames, available), side == &initial,
                     capture->depth(0)});
    }
  }
  return all;
}

void refuse_copies(const Given& a, const Given& b) {
  if (a.first != b.first || !are_copies(a.capture, a.frames, b.capture, b.frames)) return;
  if (a.initial != b.initial)
    throw Error("initial and final",
                "the frames of both captures are identical, so one is a copy of the other", take_both);
  throw Error(a.initial ? "initial captures" : "final captures",
              "the frames of two captures are identical, so one is a copy of the other", give_once);
}

}  // namespace

void require_distinct(std::span<const std::filesystem::path> initial,
                      std::span<const std::filesystem::path> final) {
  std::vector<GivenPath> all;
  for (const std::filesystem::path& path : initial) all.push_back({path, true});
  for (const std::filesystem::path& path : final) all.push_back({path, false});
  for_each_pair(all, [](const GivenPath& a, const GivenPath& b) {
    std::error_code missing;  // which opening the capture reports
    if (!std::filesystem::equivalent(a.path, b.path, missing) || missing) return;
    if (a.initial != b.initial) throw Error(printable(b.path), "both sides are the same capture", take_both);
    throw Error(printable(b.path), "is given twice for one side", give_once);
  });
}

void require_genuine(const Captures& initial, const Captures& final, std::size_t frames) {
  const std::vector<Given> all = given(initial, final, frames);
  for (const Given& each : all) {
    if (is_frozen(each.capture, each.frames))
      throw frozen_camera(each.initial ? "initial capture" : "final capture");
  }
  for_each_pair(all, refuse_copies);
}

}  // namespace rva
