#include "sim/sensor/infrared_renderer.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "core/random.hpp"
#include "depth/mat_view.hpp"
#include "sim/sensor/surface_row.hpp"

namespace rva {

namespace {

// The irradiance of a point source with this pattern; its mean is 1 at 1 m along the axis.
float irradiance(const DotPattern& dots, const Eigen::Vector3f& from_projector, float shift) {
  const float z = from_projector.z();
  if (z <= 0.0F) return 0.0F;
  return dots.at(from_projector.x() / z - shift, from_projector.y() / z) / from_projector.squaredNorm();
}

void blur(Image<float>& image, double sigma_px) {
  if (sigma_px <= 0.0) return;
  cv::Mat pixels = as_mat(image);
  cv::GaussianBlur(pixels, pixels, cv::Size(0, 0), sigma_px, sigma_px, cv::BORDER_REPLICATE);
}

}  // namespace

struct InfraredRenderer::Eye {
  Eigen::Vector3d position_m;  // in the camera's frame
  Misalignment misalignment;   // of this imager
  double dots_px = 0.0;        // displacement of the projector's pattern
  const RectificationError& error;

  // The pixel of an ideal rig that receives the light of this pixel.
  [[nodiscard]] Eigen::Vector2d ideal(const Intrinsics& imager, double u, double v) const {
    const double from_center = (u - imager.cx) / (imager.width / 2.0);
    return Eigen::Vector2d(u - misalignment.offset_px - misalignment.scale_px * from_center,
                           v - misalignment.row_offset_px - misalignment.row_turn_px * from_center) -
           error.at(u, v);
  }
};

/// Shades the samples of one row of pixels at a time.
class InfraredRenderer::RowShader {
 public:
  RowShader(const InfraredRenderer& renderer, const Eye& eye, const Transform& world_from_camera,
            int supersampling, const OwnLight& light)
      : renderer_(renderer),
        eye_(eye),
        projects_(light.projector),
        turn_(world_from_camera.rotation().cast<float>()),
        origin_((world_from_camera * eye.position_m).cast<float>()),
        projector_((world_from_camera * renderer.rig_.projector_m).cast<float>()),
        lamp_{world_from_camera * renderer.rig_.lamp_m, light.lamp * renderer.lamp_light_},
        dots_shift_(static_cast<float>(eye.dots_px / renderer.rig_.imager.fx)),
        supersampling_(supersampling),
        row_(renderer.scene_, renderer.rays_,
             static_cast<std::size_t>(renderer.rig_.imager.width * supersampling)) {}

  /// Adds the mean light of a row of pixels.
  void shade(int v, float* steady, float* projected) {
    for (int sub = 0; sub < supersampling_; ++sub) {
      aim(v + offset(sub));
      row_.cast();
      if (projects_) {
        row_.find_shadows(projector_);
        add(projected, [&](std::size_t i) { return from_projector(i); });
      }
      if (lamp_.strength > 0.0) add_lamp(lamp_, steady);
      add(steady, [&](std::size_t i) { return from_around(i); });
      for (const Lamp& lamp : renderer_.scene_.lighting.lamps) add_lamp(lamp, steady);
    }
  }

 private:
  [[nodiscard]] double offset(int sub) const { return (sub + 0.5) / supersampling_ - 0.5; }
  [[nodiscard]] float weight() const { return 1.0F / static_cast<float>(supersampling_ * supersampling_); }

  template <typename Light>
  void add(float* pixels, Light light_of_sample) const {
    std::size_t sample = 0;
    for (int u = 0; u < renderer_.rig_.imager.width; ++u) {
      for (int sub = 0; sub < supersampling_; ++sub) pixels[u] += weight() * light_of_sample(sample++);
    }
  }

  void add_lamp(const Lamp& lamp, float* steady) {
    row_.find_shadows(lamp.position_m.cast<float>());
    add(steady, [&](std::size_t i) { return from_lamp(i, lamp); });
  }

  [[nodiscard]] Eigen::Vector3f direction(double u, double v) const {
    const Intrinsics& imager = renderer_.rig_.imager;
    return turn_ * imager.deproject(eye_.ideal(imager, u, v), 1.0).cast<float>();
  }

  void aim(double v) {
    if (eye_.error.is_none())
      aim_evenly(v);
    else
      aim_one_by_one(v);
  }

  // Lenses have no distortion, so directions along a row are evenly spaced.
  void aim_evenly(double v) {
    const Eigen::Vector3f first = direction(offset(0), v);
    const Eigen::Vector3f last = direction(renderer_.rig_.imager.width - 1 + offset(supersampling_ - 1), v);
    const Eigen::Vector3f step = (last - first) / static_cast<float>(row_.samples() - 1);
    for (std::size_t i = 0; i < row_.samples(); ++i)
      row_.rays()[i] = {origin_, first + static_cast<float>(i) * step};
  }

  void aim_one_by_one(double v) {
    for (std::size_t i = 0; i < row_.samples(); ++i) {
      const double u = offset(0) + static_cast<double>(i) / supersampling_;
      row_.rays()[i] = {origin_, direction(u, v)};
    }
  }

  [[nodiscard]] float albedo(std::size_t i) const {
    return static_cast<float>(row_.material(i).infrared_albedo) * row_.grain(i);
  }

  [[nodiscard]] float from_projector(std::size_t i) const {
    if (!row_.lit(i)) return 0.0F;
    const SurfacePoint& point = row_.point(i);
    const Eigen::Vector3f to_light = projector_ - point.position;
    const float light = irradiance(renderer_.dots_, turn_.transpose() * -to_light, dots_shift_);
    if (light <= 0.0F) return 0.0F;
    return light * reflected(row_.material(i), albedo(i), point, to_light.normalized());
  }

  [[nodiscard]] float from_around(std::size_t i) const {
    const double own = (projects_ ? 1.0 : 0.0) + lamp_.strength;
    const auto light = static_cast<float>(renderer_.scene_.lighting.ambient + own * renderer_.bounce_);
    if (!row_.seen(i) || light <= 0.0F) return 0.0F;
    return light * reflected_surroundings(row_.material(i), albedo(i), row_.point(i));
  }

  [[nodiscard]] float from_lamp(std::size_t i, const Lamp& lamp) const {
    if (!row_.lit(i)) return 0.0F;
    const SurfacePoint& point = row_.point(i);
    const Eigen::Vector3f to_light = lamp.position_m.cast<float>() - point.position;
    const float light = static_cast<float>(lamp.strength) / to_light.squaredNorm();
    return light * reflected(row_.material(i), albedo(i), point, to_light.normalized());
  }

  const InfraredRenderer& renderer_;
  const Eye& eye_;
  bool projects_;
  Eigen::Matrix3f turn_;  // world from camera
  Eigen::Vector3f origin_;
  Eigen::Vector3f projector_;
  Lamp lamp_;  // beside the imagers
  float dots_shift_;
  int supersampling_;
  SurfaceRow row_;
};

InfraredRenderer::InfraredRenderer(const Scene& scene, const RayCaster& rays,
                                   const StereoSensorOptions& options)
    : scene_(scene),
      rays_(rays),
      rig_(stereo_rig(options)),
      dots_(options.dots, options.dot_share, mix(options.device, 0xD075)),
      left_error_(options, rig_.imager, mix(options.device, 0x2EC7, 1)),
      right_error_(options, rig_.imager, mix(options.device, 0x2EC7, 2)),
      lens_blur_px_(options.lens_blur_px),
      bounce_(options.bounce),
      lamp_light_(options.lamp_light) {}

ImagerLight InfraredRenderer::render_eye(const Eye& eye, const Transform& world_from_camera,
                                         int supersampling, const OwnLight& light) const {
  ImagerLight view{Image<float>(rig_.imager.width, rig_.imager.height),
                   Image<float>(rig_.imager.width, rig_.imager.height)};
  parallel_bands(rig_.imager.height, [&](int first, int end) {
    RowShader shader(*this, eye, world_from_camera, supersampling, light);
    for (int v = first; v < end; ++v) {
      throw_if_interrupted();
      shader.shade(v, &view.steady(0, v), &view.projected(0, v));
    }
  });
  blur(view.steady, lens_blur_px_);
  blur(view.projected, lens_blur_px_);
  return view;
}

InfraredPair InfraredRenderer::render(const Transform& world_from_camera, const Misalignment& misalignment,
                                      int supersampling, const OwnLight& light) const {
  const Eye left{Eigen::Vector3d::Zero(), Misalignment{}, misalignment.dots_px, left_error_};
  const Eye right{Eigen::Vector3d(rig_.baseline_m, 0.0, 0.0), misalignment, misalignment.dots_px,
                  right_error_};
  return {render_eye(left, world_from_camera, supersampling, light),
          render_eye(right, world_from_camera, supersampling, light)};
}

TrueView InfraredRenderer::true_view(const Transform& world_from_camera) const {
  const int width = rig_.imager.width;
  TrueView view{Image<float>(width, rig_.imager.height), LabelImage(width, rig_.imager.height)};
  const Eigen::Vector3f origin = world_from_camera.translation().cast<float>();
  parallel_bands(rig_.imager.height, [&](int first, int end) {
    std::vector<Ray> rays(static_cast<std::size_t>(width));
    std::vector<Hit> hits(rays.size());
    for (int v = first; v < end; ++v) {
      for (int u = 0; u < width; ++u) {
        const Eigen::Vector3d direction = world_from_camera.rotation() * rig_.imager.deproject({u, v}, 1.0);
        rays[static_cast<std::size_t>(u)] = {origin, direction.cast<float>()};
      }
      rays_.cast(rays, hits);
      for (int u = 0; u < width; ++u) {
        const Hit& hit = hits[static_cast<std::size_t>(u)];
        if (hit.object == Hit::none) continue;
        view.depth_m(u, v) = hit.distance;
        view.labels(u, v) = static_cast<std::uint16_t>(Scene::label_of(hit.object));
      }
    }
  });
  return view;
}

}  // namespace rva
