#include "scene/ray_caster.hpp"

#include <embree3/rtcore.h>

#include <array>
#include <cassert>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

namespace rva {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

struct Origin {
  std::uint32_t object;
  std::uint32_t part;
};

std::vector<std::size_t> all_objects(const Scene& scene) {
  std::vector<std::size_t> objects(scene.objects.size());
  std::iota(objects.begin(), objects.end(), std::size_t{0});
  return objects;
}

void fill(RTCRay& query, const Ray& ray, float far) {
  query.org_x = ray.origin.x();
  query.org_y = ray.origin.y();
  query.org_z = ray.origin.z();
  query.dir_x = ray.direction.x();
  query.dir_y = ray.direction.y();
  query.dir_z = ray.direction.z();
  query.tnear = 0.0F;
  query.tfar = far;
  query.time = 0.0F;
  query.mask = ~0U;
  query.id = 0;
  query.flags = 0;
}

RTCIntersectContext coherent_context() {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

}  // namespace

struct RayCaster::Impl {
  Impl(const Scene& scene, std::span<const std::size_t> objects)
      // One thread: trees are small, and a tree built by several may differ from run to run.
      : device(rtcNewDevice("threads=1")), tree(rtcNewScene(device)) {
    // Rays must not slip between triangles that share an edge.
    rtcSetSceneFlags(tree, RTC_SCENE_FLAG_ROBUST);
    for (const std::size_t object : objects) {
      for (std::size_t part = 0; part < scene.objects[object].parts.size(); ++part) {
        attach(transformed(scene.objects[object].parts[part].mesh, scene.objects[object].world_from_object));
        origins.push_back({static_cast<std::uint32_t>(object), static_cast<std::uint32_t>(part)});
      }
    }
    rtcCommitScene(tree);
  }
  ~Impl() {
    rtcReleaseScene(tree);
    rtcReleaseDevice(device);
  }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void attach(const TriangleMesh& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    copy_to(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices);
    copy_to(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(tree, geometry, static_cast<unsigned>(origins.size()));
    rtcReleaseGeometry(geometry);
  }

  template <typename Element>
  static void copy_to(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                      const std::vector<Element>& elements) {
    static_assert(sizeof(Element) == 12);
    if (elements.empty()) return;
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), elements.size());
    std::memcpy(buffer, elements.data(), elements.size() * sizeof(Element));
  }

  RTCDevice device;
  RTCScene tree;
  std::vector<Origin> origins;  // by Embree's geometry id
};

RayCaster::RayCaster(const Scene& scene) : RayCaster(scene, all_objects(scene)) {}

RayCaster::RayCaster(const Scene& scene, std::span<const std::size_t> objects)
    : impl_(std::make_unique<Impl>(scene, objects)) {}

RayCaster::~RayCaster() = default;

void RayCaster::cast(std::span<const Ray> rays, std::span<Hit> hits) const {
  assert(rays.size() == hits.size());
  RTCIntersectContext context = coherent_context();
  std::vector<RTCRayHit> queries(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    fill(queries[i].ray, rays[i], infinity);
    queries[i].hit.geomID = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect1M(impl_->tree, &context, queries.data(), static_cast<unsigned>(queries.size()),
                 sizeof(RTCRayHit));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const RTCHit& hit = queries[i].hit;
    if (hit.geomID == RTC_INVALID_GEOMETRY_ID) {
      hits[i] = {infinity, Hit::none, 0, 0, Eigen::Vector3f::Zero()};
      continue;
    }
    const Eigen::Vector3f normal(hit.Ng_x, hit.Ng_y, hit.Ng_z);
    hits[i] = {queries[i].ray.tfar, impl_->origins[hit.geomID].object, impl_->origins[hit.geomID].part,
               hit.primID, normal.normalized()};
  }
}

void RayCaster::occluded(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const {
  assert(rays.size() == blocked.size());
  RTCIntersectContext context = coherent_context();
  std::vector<RTCRay> queries(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) fill(queries[i], rays[i], 1.0F);
  rtcOccluded1M(impl_->tree, &context, queries.data(), static_cast<unsigned>(queries.size()), sizeof(RTCRay));
  // Embree sets tfar of an occluded ray to minus infinity.
  for (std::size_t i = 0; i < rays.size(); ++i) blocked[i] = queries[i].tfar < 0.0F ? 1 : 0;
}

std::optional<Hit> RayCaster::cast(const Ray& ray) const {
  Hit hit{};
  cast(std::span(&ray, 1), std::span(&hit, 1));
  if (hit.object == Hit::none) return std::nullopt;
  return hit;
}

std::optional<std::size_t> RayCaster::solid_around(const Eigen::Vector3d& point) const {
  // A ray that leaves a solid more often than it enters it started inside. The direction is oblique, so that
  // it is unlikely to lie in a surface of the scene.
  const Eigen::Vector3f direction = Eigen::Vector3f(0.1234F, 0.2718F, 0.9513F).normalized();
  constexpr float step_past_m = 1e-5F;
  constexpr int most_surfaces = 1000;
  std::map<std::uint32_t, int> exits;
  Eigen::Vector3f origin = point.cast<float>();
  for (int surfaces = 0; surfaces < most_surfaces; ++surfaces) {
    const std::optional<Hit> hit = cast(Ray{origin, direction});
    if (!hit) break;
    exits[hit->object] += hit->normal.dot(direction) > 0.0F ? 1 : -1;
    origin += (hit->distance + step_past_m) * direction;
  }
  for (const auto& [object, count] : exits) {
    if (count > 0) return object;
  }
  return std::nullopt;
}

}  // namespace rva
