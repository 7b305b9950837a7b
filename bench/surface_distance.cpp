#include "bench/surface_distance.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

namespace rva {
namespace {

struct Search {
  const TriangleMesh* mesh;
  Eigen::Vector3f point;
};

// The nearest point on a triangle (Ericson, Real-Time Collision Detection, 2005, section 5.1.5).
Eigen::Vector3f nearest_on_triangle(const Eigen::Vector3f& p, const std::array<Eigen::Vector3f, 3>& corner) {
  const Eigen::Vector3f ab = corner[1] - corner[0];
  const Eigen::Vector3f ac = corner[2] - corner[0];
  const Eigen::Vector3f ap = p - corner[0];
  const float d1 = ab.dot(ap);
  const float d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return corner[0];
  const Eigen::Vector3f bp = p - corner[1];
  const float d3 = ab.dot(bp);
  const float d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return corner[1];
  const Eigen::Vector3f cp = p - corner[2];
  const float d5 = ab.dot(cp);
  const float d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return corner[2];
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return corner[0] + d1 / (d1 - d3) * ab;
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return corner[0] + d2 / (d2 - d6) * ac;
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6)
    return corner[1] + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (corner[2] - corner[1]);
  const float by = 1.0F / (va + vb + vc);
  return corner[0] + by * (vb * ab + vc * ac);
}

bool visit_triangle(RTCPointQueryFunctionArguments* arguments) {
  const auto& search = *static_cast<const Search*>(arguments->userPtr);
  const auto& triangle = search.mesh->triangles[arguments->primID];
  const std::array<Eigen::Vector3f, 3> corners{search.mesh->vertices[triangle[0]],
                                               search.mesh->vertices[triangle[1]],
                                               search.mesh->vertices[triangle[2]]};
  const float distance = (nearest_on_triangle(search.point, corners) - search.point).norm();
  if (distance >= arguments->query->radius) return false;
  arguments->query->radius = distance;
  return true;
}

}  // namespace

struct SurfaceDistance::Impl {
  TriangleMesh mesh;
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene scene = rtcNewScene(device);

  ~Impl() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

SurfaceDistance::SurfaceDistance(const Scene& scene) : impl_(std::make_unique<Impl>()) {
  for (const SceneObject& object : scene.objects) impl_->mesh.append(world_mesh(object));
  const TriangleMesh& mesh = impl_->mesh;
  const RTCGeometry geometry = rtcNewGeometry(impl_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* const vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                 3 * sizeof(float), mesh.vertices.size());
  void* const triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                  3 * sizeof(std::uint32_t), mesh.triangles.size());
  if (vertices == nullptr || triangles == nullptr) throw std::bad_alloc();
  std::memcpy(vertices, mesh.vertices.data(), mesh.vertices.size() * sizeof(mesh.vertices[0]));
  std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * sizeof(mesh.triangles[0]));
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(impl_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(impl_->scene);
}

SurfaceDistance::~SurfaceDistance() = default;

double SurfaceDistance::distance_m(const Eigen::Vector3d& point, double most_m) const {
  Search search{&impl_->mesh, point.cast<float>()};
  RTCPointQuery query{search.point.x(), search.point.y(), search.point.z(), 0.0F, static_cast<float>(most_m)};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(impl_->scene, &query, &context, visit_triangle, &search);
  return static_cast<double>(query.radius);
}

}  // namespace rva
