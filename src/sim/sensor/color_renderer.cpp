#include "sim/sensor/color_renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "sim/sensor/surface_row.hpp"

namespace rva {

namespace {

// Room light: a lamp above and behind the near spar, and ambient light.
const Eigen::Vector3f room_lamp_m{0.4F, -0.6F, 2.0F};
constexpr float room_lamp_share = 0.7F;
constexpr float around_share = 0.45F;
// What a white surface returns of the robot's lamp at 1 m and full brightness: an assumption.
constexpr float own_lamp_light = 0.5F;
constexpr float read_noise = 0.004F;
constexpr float shot_noise = 0.010F;
constexpr double gamma = 2.2;

float linear(std::uint8_t value) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<float>(std::pow(static_cast<double>(i) / 255.0, gamma));
    return values;
  }();
  return table[value];
}

Eigen::Vector3f color_of(const Material& material) {
  return {linear(material.color.r), linear(material.color.g), linear(material.color.b)};
}

class RowPainter {
 public:
  RowPainter(const Scene& scene, const RayCaster& caster, const Intrinsics& imager,
             const Transform& world_from_color, int supersampling, const Lamp& lamp)
      : weight_(1.0F / static_cast<float>(supersampling * supersampling)),
        room_(static_cast<float>(scene.lighting.visible)),
        lamp_m_(lamp.position_m.cast<float>()),
        lamp_(static_cast<float>(lamp.strength)),
        imager_(imager),
        world_from_color_(world_from_color),
        supersampling_(supersampling),
        row_(scene, caster, static_cast<std::size_t>(imager.width * supersampling)) {}

  void paint(int v, ColorView& view) {
    for (int sub = 0; sub < supersampling_; ++sub) {
      aim(v + offset(sub));
      row_.cast();
      row_.find_shadows(room_lamp_m);
      add(v, view, [&](std::size_t i) { return room_ * from_room(i); });
      if (lamp_ <= 0.0F) continue;
      row_.find_shadows(lamp_m_);
      add(v, view, [&](std::size_t i) { return lamp_ * from_lamp(i); });
    }
  }

 private:
  [[nodiscard]] double offset(int sub) const { return (sub + 0.5) / supersampling_ - 0.5; }

  // Lenses have no distortion, so directions along a row are evenly spaced.
  void aim(double v) {
    const Eigen::Vector3f origin = world_from_color_.translation().cast<float>();
    const auto direction = [&](double u) {
      return Eigen::Vector3d(world_from_color_.rotation() * imager_.deproject({u, v}, 1.0));
    };
    const Eigen::Vector3f first = direction(offset(0)).cast<float>();
    const Eigen::Vector3f last = direction(imager_.width - 1 + offset(supersampling_ - 1)).cast<float>();
    const Eigen::Vector3f step = (last - first) / static_cast<float>(row_.samples() - 1);
    for (std::size_t i = 0; i < row_.samples(); ++i)
      row_.rays()[i] = {origin, first + static_cast<float>(i) * step};
  }

  // Light is computed per unit of albedo and then multiplied by the colour, so that the glossy lobe of paint
  // and metal is coloured as well.
  template <typename LightOfSample>
  void add(int v, ColorView& view, const LightOfSample& light_of) const {
    std::size_t sample = 0;
    for (int u = 0; u < imager_.width; ++u) {
      for (int sub = 0; sub < supersampling_; ++sub, ++sample) {
        if (!row_.seen(sample)) continue;
        const Eigen::Vector3f color = weight_ * light_of(sample) * color_of(row_.material(sample));
        view.red(u, v) += color.x();
        view.green(u, v) += color.y();
        view.blue(u, v) += color.z();
      }
    }
  }

  [[nodiscard]] float from_room(std::size_t i) const {
    const float around =
        around_share * reflected_surroundings(row_.material(i), row_.grain(i), row_.point(i));
    return row_.lit(i) ? around + room_lamp_share * reflected_from(i, room_lamp_m) : around;
  }

  [[nodiscard]] float from_lamp(std::size_t i) const {
    if (!row_.lit(i)) return 0.0F;
    return own_lamp_light * reflected_from(i, lamp_m_) / (lamp_m_ - row_.point(i).position).squaredNorm();
  }

  [[nodiscard]] float reflected_from(std::size_t i, const Eigen::Vector3f& light_m) const {
    const SurfacePoint& point = row_.point(i);
    return reflected(row_.material(i), row_.grain(i), point, (light_m - point.position).normalized());
  }

  float weight_;  // of a sample in its pixel
  float room_;    // strength of the room's light
  Eigen::Vector3f lamp_m_;
  float lamp_;  // share of the full light of the lamp beside the imagers
  const Intrinsics& imager_;
  const Transform& world_from_color_;
  int supersampling_;
  SurfaceRow row_;
};

// Gamma encoding by a table: 4096 steps of light are finer than 8 bits everywhere except near black.
std::uint8_t encoded(float light) {
  constexpr std::size_t steps = 4096;
  static const std::array<std::uint8_t, steps> table = [] {
    std::array<std::uint8_t, steps> values{};
    for (std::size_t i = 0; i < steps; ++i)
      values[i] = static_cast<std::uint8_t>(
          std::lround(255.0 * std::pow(static_cast<double>(i) / (steps - 1.0), 1.0 / gamma)));
    return values;
  }();
  return table[static_cast<std::size_t>(std::clamp(light, 0.0F, 1.0F) * (steps - 1) + 0.5F)];
}

}  // namespace

ColorView render_color(const Scene& scene, const RayCaster& rays, const StereoRig& rig,
                       const Transform& world_from_depth, int supersampling, double lamp) {
  const Transform world_from_color = world_from_depth * rig.color_from_depth.inverse();
  const Image<float> black(rig.color.width, rig.color.height);
  ColorView view{black, black, black};
  parallel_bands(rig.color.height, [&](int first, int end) {
    RowPainter painter(scene, rays, rig.color, world_from_color, supersampling,
                       {world_from_depth * rig.lamp_m, lamp});
    for (int v = first; v < end; ++v) {
      throw_if_interrupted();
      painter.paint(v, view);
    }
  });
  return view;
}

ColorImage expose_color(const ColorView& view, std::uint64_t seed) {
  ColorImage image(view.red.width(), view.red.height());
  parallel_bands(image.height(), [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      Random random(mix(seed, v));
      // Uniform noise of the right variance is sufficient: the picture is for display, not for measurement.
      const auto noisy = [&random](float light) {
        const auto noise = static_cast<float>(random.uniform(-1.732, 1.732));
        return encoded(light + noise * (read_noise + shot_noise * std::sqrt(light)));
      };
      for (int u = 0; u < image.width(); ++u)
        image(u, v) = {noisy(view.red(u, v)), noisy(view.green(u, v)), noisy(view.blue(u, v))};
    }
  });
  return image;
}

}  // namespace rva
