#include "ray_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>
#include <embree3/rtcore.h>

namespace mixed_palletizing::simulation {
namespace {

/// A shadow ray starts and ends this much short of its ends, so that it does not meet its own surface.
constexpr float kShadowMargin = 1e-4f;

/// Embree's depth is never off by more than this [m], unless the ray runs along the plane.
constexpr double kCoarseDepthError = 1e-3;

struct Facet {
  Eigen::Vector3d normal;
  double distance;  // normal . p of its points
  std::uint8_t face;
};

std::vector<Facet> facetsOf(const Mesh& mesh) {
  std::vector<Facet> facets;
  facets.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Eigen::Vector3d& a = mesh.vertices[mesh.triangles[i][0]];
    const Eigen::Vector3d& b = mesh.vertices[mesh.triangles[i][1]];
    const Eigen::Vector3d& c = mesh.vertices[mesh.triangles[i][2]];
    const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
    facets.push_back({normal, normal.dot(a), mesh.faces[i]});
  }
  return facets;
}

void attach(RTCDevice device, RTCScene scene, const Mesh& mesh, unsigned id) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t),
                              mesh.triangles.size()));
  if (vertices == nullptr || indices == nullptr) {
    rtcReleaseGeometry(geometry);
    throw std::runtime_error("RayScene: Embree has no memory for a mesh of " +
                             std::to_string(mesh.triangles.size()) + " triangles");
  }
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(vertex[axis]);
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) *indices++ = corner;
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

RTCRayHit rayHit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  RTCRayHit query = {};
  query.ray.org_x = static_cast<float>(origin.x());
  query.ray.org_y = static_cast<float>(origin.y());
  query.ray.org_z = static_cast<float>(origin.z());
  query.ray.dir_x = static_cast<float>(direction.x());
  query.ray.dir_y = static_cast<float>(direction.y());
  query.ray.dir_z = static_cast<float>(direction.z());
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return query;
}

}  // namespace

struct RayScene::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<std::vector<Facet>> facets;  // by object

  /// What a ray through the camera met at Embree's distance.
  RayHit hit(unsigned object, unsigned triangle, float distance, const Eigen::Vector3d& direction) const {
    const Facet& facet = facets[object][triangle];
    RayHit hit;
    hit.object = static_cast<int>(object);
    hit.face = facet.face;
    const double against = facet.normal.dot(direction);
    hit.normal = against > 0.0 ? Eigen::Vector3d(-facet.normal) : facet.normal;
    // The direction has z = 1, so that Embree's distance is the depth; it has the precision of a float only. A
    // plane seen from its edge says nothing.
    const auto coarse = static_cast<double>(distance);
    const double exact = facet.distance / against;
    hit.depth_m = std::abs(exact - coarse) < kCoarseDepthError ? exact : coarse;
    return hit;
  }

  ~Impl() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RayScene::RayScene(const std::vector<Mesh>& objects) : impl_(std::make_unique<Impl>()) {
  impl_->device = rtcNewDevice("threads=1");
  if (impl_->device == nullptr) {
    throw std::runtime_error("RayScene: Embree error " + std::to_string(rtcGetDeviceError(nullptr)));
  }
  impl_->scene = rtcNewScene(impl_->device);
  rtcSetSceneFlags(impl_->scene, RTC_SCENE_FLAG_ROBUST);  // no holes along the edges of triangles
  for (std::size_t i = 0; i < objects.size(); ++i) {
    attach(impl_->device, impl_->scene, objects[i], static_cast<unsigned>(i));
    impl_->facets.push_back(facetsOf(objects[i]));
  }
  rtcCommitScene(impl_->scene);
  const RTCError error = rtcGetDeviceError(impl_->device);
  if (error != RTC_ERROR_NONE) throw std::runtime_error("RayScene: Embree error " + std::to_string(error));
}

RayScene::~RayScene() = default;

RayHits RayScene::trace(const RayDirections& directions) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(32) std::array<int, kPacketSize> valid;
  RTCRayHit8 query = {};
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    valid[i] = -1;
    query.ray.dir_x[i] = static_cast<float>(directions[i].x());
    query.ray.dir_y[i] = static_cast<float>(directions[i].y());
    query.ray.dir_z[i] = static_cast<float>(directions[i].z());
    query.ray.tfar[i] = std::numeric_limits<float>::infinity();
    query.ray.mask[i] = ~0u;
    query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  rtcIntersect8(valid.data(), impl_->scene, &context, &query);
  RayHits hits;
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    if (query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    hits[i] = impl_->hit(query.hit.geomID[i], query.hit.primID[i], query.ray.tfar[i], directions[i]);
  }
  return hits;
}

RayFlags RayScene::areBlocked(const RayDirections& surface_points, const RayFlags& asked,
                              const Eigen::Vector3d& other) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  alignas(32) std::array<int, kPacketSize> valid;
  RTCRay8 rays = {};
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    valid[i] = asked[i] ? -1 : 0;
    const Eigen::Vector3d path = other - surface_points[i];
    const double length = path.norm();
    const Eigen::Vector3f direction = (path / length).cast<float>();
    rays.org_x[i] = static_cast<float>(surface_points[i].x());
    rays.org_y[i] = static_cast<float>(surface_points[i].y());
    rays.org_z[i] = static_cast<float>(surface_points[i].z());
    rays.dir_x[i] = direction.x();
    rays.dir_y[i] = direction.y();
    rays.dir_z[i] = direction.z();
    rays.tnear[i] = kShadowMargin;
    rays.tfar[i] = static_cast<float>(length) - kShadowMargin;
    rays.mask[i] = ~0u;
  }
  rtcOccluded8(valid.data(), impl_->scene, &context, &rays);
  RayFlags blocked;
  for (std::size_t i = 0; i < kPacketSize; ++i) {
    blocked[i] = asked[i] && rays.tfar[i] < 0.0f;  // Embree sets it to -inf
  }
  return blocked;
}

bool RayScene::isPierced(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double margin) const {
  constexpr float kStep = 1e-5f;  // of the segment, from one triangle to the next
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (float start = 0.0f; start < 1.0f;) {
    RTCRayHit query = rayHit(from, to - from);
    query.ray.tnear = start;
    query.ray.tfar = 1.0f;
    rtcIntersect1(impl_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    const Facet& facet = impl_->facets[query.hit.geomID][query.hit.primID];
    const double before = facet.normal.dot(from) - facet.distance;
    const double behind = facet.normal.dot(to) - facet.distance;
    if (before * behind < 0.0 && std::min(std::abs(before), std::abs(behind)) > margin) return true;
    start = query.ray.tfar + kStep;
  }
  return false;
}

}  // namespace mixed_palletizing::simulation
