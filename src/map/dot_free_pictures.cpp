#include "map/dot_free_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "capture/memory_capture.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "views/depth_view.hpp"

namespace rva {
namespace {

PictureImager imager_of(const CaptureInfo& info, Light light) {
  if (light == Light::lamp) return {info.depth, Transform::Identity()};
  if (!info.color || !info.color_from_depth)
    throw Error("camera", "has no lamp and no colour imager, so its pictures show the projector's dots",
                "use a camera with a colour imager");
  return {*info.color, *info.color_from_depth};
}

// The root of linear light.
std::optional<Image<float>> picture_of(const FineGrayImage& infrared) {
  Image<float> picture(infrared.width(), infrared.height());
  std::ranges::transform(infrared.pixels(), picture.pixels().begin(), [](std::uint16_t light) {
    return std::sqrt(static_cast<float>(light) / static_cast<float>(fine_steps_per_grey_level));
  });
  return picture;
}

// Colour images are encoded in nearly the root of light.
Image<float> picture_of(const ColorImage& color) {
  Image<float> picture(color.width(), color.height());
  std::ranges::transform(color.pixels(), picture.pixels().begin(), [](const Rgb& pixel) {
    return 0.299F * static_cast<float>(pixel.r) + 0.587F * static_cast<float>(pixel.g) +
           0.114F * static_cast<float>(pixel.b);
  });
  return picture;
}

std::optional<Image<float>> picture_of(const CameraFrame& frame, Light light) {
  if (light == Light::projector) return frame.color ? std::optional(picture_of(*frame.color)) : std::nullopt;
  const auto left = frame.infrared.find(Imager::left);
  return left == frame.infrared.end() ? std::nullopt : picture_of(left->second);
}

void add(const Image<float>& picture, Image<float>& sum) {
  if (sum.empty()) sum = Image<float>(picture.width(), picture.height());
  std::ranges::transform(sum.pixels(), picture.pixels(), sum.pixels().begin(), std::plus{});
}

}  // namespace

DotFreePictures::DotFreePictures(Camera& camera)
    : camera_(camera),
      light_(camera.has_lamp() ? Light::lamp : Light::projector),
      imager_(imager_of(camera.info(), light_)) {
  camera_.set_light(light_);
}

DotFreePictures::~DotFreePictures() { camera_.set_light(Light::projector); }

std::string_view DotFreePictures::name() const {
  return light_ == Light::lamp ? "infrared under the lamp" : "colour";
}

CameraFrame DotFreePictures::next_frame() {
  throw_if_interrupted();
  std::optional<CameraFrame> frame = camera_.wait_for_frame();
  if (!frame) throw Error("camera", "the recording ended", "use a camera that goes on");
  return std::move(*frame);
}

void DotFreePictures::settle() {
  constexpr int frames = 2;
  camera_.drop_waiting();
  for (int i = 0; i < frames; ++i) static_cast<void>(next_frame());
}

Image<float> DotFreePictures::take(int frames) {
  constexpr int most_missing = 30;  // a colour imager may be slower than depth
  Image<float> sum;
  for (int taken = 0, missing = 0; taken < frames;) {
    const std::optional<Image<float>> picture = picture_of(next_frame(), light_);
    if (picture) {
      add(*picture, sum);
      ++taken;
    } else if (++missing > most_missing) {
      throw Error("camera", "gives no images that are " + std::string(name()), "switch these images on");
    }
  }
  for (float& brightness : sum.pixels()) brightness /= static_cast<float>(frames);
  return sum;
}

ReferenceSurface DotFreePictures::surface(int frames) {
  camera_.set_light(Light::projector);
  std::vector<MemoryFrame> depth;
  for (int i = 0; i < frames; ++i) depth.push_back({next_frame().depth});
  camera_.set_light(light_);
  const DepthView view = depth_view(MemoryCapture(camera_.info(), std::move(depth)));
  ReferenceSurface surface = reference_surface(view.camera, view.disparity_px, view.stereo);
  if (surface.inverse_depth_per_m.empty())
    throw Error("camera", "measures no depth here", "aim it at surfaces 0.3 to 3 m ahead");
  return surface;
}

}  // namespace rva
