#include "sim/sensor/surface_row.hpp"

#include "sim/sensor/trace_light.hpp"

namespace rva {

namespace {

constexpr float off_surface_m = 1e-4F;  // offset of shadow rays, so that a surface does not shade itself

SurfacePoint surface_at(const Ray& ray, const Hit& hit) {
  SurfacePoint point;
  point.position = ray.origin + hit.distance * ray.direction;
  point.to_eye = -ray.direction.normalized();
  point.normal = hit.normal.dot(point.to_eye) < 0.0F ? Eigen::Vector3f(-hit.normal) : hit.normal;
  return point;
}

}  // namespace

SurfaceRow::SurfaceRow(const Scene& scene, const RayCaster& caster, std::size_t samples)
    : scene_(scene),
      caster_(caster),
      rays_(samples),
      shadow_rays_(samples),
      hits_(samples),
      points_(samples),
      materials_(samples),
      grains_(samples),
      shaded_(samples) {}

void SurfaceRow::cast() {
  caster_.cast(rays_, hits_);
  for (std::size_t i = 0; i < samples(); ++i) {
    if (!seen(i)) continue;
    points_[i] = surface_at(rays_[i], hits_[i]);
    materials_[i] = &scene_.objects[hits_[i].object].parts[hits_[i].part].material;
    grains_[i] =
        grain_at(*materials_[i], points_[i].position) * trace_light(scene_.traces, points_[i].position);
  }
}

void SurfaceRow::find_shadows(const Eigen::Vector3f& light_m) {
  for (std::size_t i = 0; i < samples(); ++i) {
    const Eigen::Vector3f from =
        seen(i) ? Eigen::Vector3f(points_[i].position + off_surface_m * points_[i].normal) : light_m;
    shadow_rays_[i] = {from, light_m - from};
  }
  caster_.occluded(shadow_rays_, shaded_);
}

}  // namespace rva
