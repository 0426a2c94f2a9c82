#include "ray_scene.hpp"

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

}  // namespace

struct RayScene::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::vector<std::vector<Facet>> facets;  // by object

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

RayHit RayScene::trace(const Eigen::Vector3d& direction) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  RTCRayHit query = {};
  query.ray.dir_x = static_cast<float>(direction.x());
  query.ray.dir_y = static_cast<float>(direction.y());
  query.ray.dir_z = static_cast<float>(direction.z());
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->scene, &context, &query);
  RayHit hit;
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
  const Facet& facet = impl_->facets[query.hit.geomID][query.hit.primID];
  hit.object = static_cast<int>(query.hit.geomID);
  hit.face = facet.face;
  hit.normal = facet.normal;
  // The direction has z = 1, so that Embree's distance is the depth; it has the precision of a float only. A
  // plane seen from its edge says nothing.
  const auto coarse = static_cast<double>(query.ray.tfar);
  const double exact = facet.distance / facet.normal.dot(direction);
  hit.depth_m = std::abs(exact - coarse) < kCoarseDepthError ? exact : coarse;
  return hit;
}

bool RayScene::isBlocked(const Eigen::Vector3d& surface_point, const Eigen::Vector3d& other) const {
  const Eigen::Vector3d path = other - surface_point;
  const auto length = static_cast<float>(path.norm());
  const Eigen::Vector3f direction = (path / path.norm()).cast<float>();
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray = {};
  ray.org_x = static_cast<float>(surface_point.x());
  ray.org_y = static_cast<float>(surface_point.y());
  ray.org_z = static_cast<float>(surface_point.z());
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tnear = kShadowMargin;
  ray.tfar = length - kShadowMargin;
  ray.mask = ~0u;
  rtcOccluded1(impl_->scene, &context, &ray);
  return ray.tfar < 0.0f;  // Embree sets it to -inf
}

}  // namespace mixed_palletizing::simulation
