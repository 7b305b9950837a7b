#include "views/rendered_view.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace rva {
namespace {

// A larger difference between neighbouring pixels is an edge rather than a surface that can be compared.
constexpr float edge_px = 1.0F;

struct Vertex {
  float u = 0.0F;
  float v = 0.0F;
  float disparity_px = 0.0F;  // 0 if invalid
};

// All pixels of a view, moved and projected. On a row, points and their depths are linear in the pixel.
std::vector<Vertex> project_all(const DepthView& view, const Intrinsics& camera, const StereoScale& stereo,
                                const Transform& camera_from_view) {
  std::vector<Vertex> vertices(view.disparity_px.size());
  const Eigen::Matrix3f rotation = camera_from_view.linear().cast<float>();
  const Eigen::Vector3f translation = camera_from_view.translation().cast<float>();
  const auto from_m_px = static_cast<float>(view.stereo.focal_baseline_m_px);
  const auto to_m_px = static_cast<float>(stereo.focal_baseline_m_px);
  const auto fx = static_cast<float>(camera.fx);
  const auto fy = static_cast<float>(camera.fy);
  const auto cx = static_cast<float>(camera.cx);
  const auto cy = static_cast<float>(camera.cy);
  constexpr float nearest_m = 0.05F;
  std::size_t i = 0;
  for (int v = 0; v < view.camera.height; ++v) {
    for (int u = 0; u < view.camera.width; ++u, ++i) {
      if (!view.seen(i)) continue;
      const float z = from_m_px / view.disparity_px[i];
      const Eigen::Vector3f ray(static_cast<float>((u - view.camera.cx) / view.camera.fx),
                                static_cast<float>((v - view.camera.cy) / view.camera.fy), 1.0F);
      const Eigen::Vector3f point = rotation * (z * ray) + translation;
      if (point.z() < nearest_m) continue;
      const float by_z = 1.0F / point.z();
      vertices[i] = {fx * point.x() * by_z + cx, fy * point.y() * by_z + cy, to_m_px * by_z};
    }
  }
  return vertices;
}

float cross(const Vertex& a, const Vertex& b, float u, float v) {
  return (b.u - a.u) * (v - a.v) - (b.v - a.v) * (u - a.u);
}

// Draws a triangle, over which disparity is linear. Triangles seen from behind are not drawn.
void draw(const Vertex& a, const Vertex& b, const Vertex& c, Image<float>& picture) {
  const float area = cross(a, b, c.u, c.v);
  if (!(area > 0.0F)) return;
  const auto last = [](int size) { return static_cast<float>(size - 1); };
  const auto left = static_cast<int>(std::ceil(std::max(std::min({a.u, b.u, c.u}), 0.0F)));
  const auto right = static_cast<int>(std::floor(std::min(std::max({a.u, b.u, c.u}), last(picture.width()))));
  const auto top = static_cast<int>(std::ceil(std::max(std::min({a.v, b.v, c.v}), 0.0F)));
  const auto bottom =
      static_cast<int>(std::floor(std::min(std::max({a.v, b.v, c.v}), last(picture.height()))));
  const float by_area = 1.0F / area;
  for (int v = top; v <= bottom; ++v) {
    for (int u = left; u <= right; ++u) {
      const float of_a = cross(b, c, static_cast<float>(u), static_cast<float>(v));
      const float of_b = cross(c, a, static_cast<float>(u), static_cast<float>(v));
      const float of_c = area - of_a - of_b;
      if (of_a < 0.0F || of_b < 0.0F || of_c < 0.0F) continue;
      const float disparity_px =
          by_area * (of_a * a.disparity_px + of_b * b.disparity_px + of_c * c.disparity_px);
      picture(u, v) = std::max(picture(u, v), disparity_px);
    }
  }
}

}  // namespace

Image<float> render(const DepthView& view, const Intrinsics& camera, const StereoScale& stereo,
                    const Transform& camera_from_view) {
  Image<float> picture(camera.width, camera.height);
  const std::vector<Vertex> vertices = project_all(view, camera, stereo, camera_from_view);
  const auto width = static_cast<std::size_t>(view.camera.width);
  for (int v = 0; v + 1 < view.camera.height; ++v) {
    for (int u = 0; u + 1 < view.camera.width; ++u) {
      const std::size_t i = static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
      const auto [least, most] =
          std::minmax({view.disparity_px[i], view.disparity_px[i + 1], view.disparity_px[i + width],
                       view.disparity_px[i + width + 1]});
      if (least <= 0.0F || most - least > edge_px) continue;
      const Vertex& upper_left = vertices[i];
      const Vertex& upper_right = vertices[i + 1];
      const Vertex& lower_left = vertices[i + width];
      const Vertex& lower_right = vertices[i + width + 1];
      if (std::min({upper_left.disparity_px, upper_right.disparity_px, lower_left.disparity_px,
                    lower_right.disparity_px}) <= 0.0F)
        continue;
      draw(upper_left, upper_right, lower_left, picture);
      draw(upper_right, lower_right, lower_left, picture);
    }
  }
  return picture;
}

}  // namespace rva
