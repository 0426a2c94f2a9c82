#include "scene_objects.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include <mixed_palletizing/simulation/pinhole.hpp>

#include "box_mesh.hpp"
#include "marker_picture.hpp"

namespace mixed_palletizing::simulation {
namespace {

using geometry::Pose;

constexpr float kWhiteInk = 240.0f;
constexpr float kBlackInk = 16.0f;

/// Rays a pixel of the marker's paper is averaged over, along a row and a column: printed edges then look as
/// smooth as to a real image sensor.
constexpr int kPaperSamples = 4;

/// A label that ends at a box's edge reaches its side [m].
constexpr double kLabelTolerance = 1e-6;

Eigen::Vector3f toVector(std::uint32_t rgb) {
  return Eigen::Vector3f(static_cast<float>((rgb >> 16) & 0xffu), static_cast<float>((rgb >> 8) & 0xffu),
                         static_cast<float>(rgb & 0xffu));
}

void addQuad(Mesh& mesh, const Pose& camera_from_object, const std::array<Eigen::Vector3d, 4>& corners,
             std::uint8_t face) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Eigen::Vector3d& corner : corners) mesh.vertices.push_back(camera_from_object * corner);
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
  mesh.faces.insert(mesh.faces.end(), 2, face);
}

class FloorSurface : public Surface {
 public:
  explicit FloorSurface(const Scene& scene) : rgb_(toVector(scene.floor.rgb)), pinhole_(scene.camera) {
    if (!scene.has_marker) return;
    picture_.emplace(scene.marker);
    marker_from_camera_ = worldFromMarker(scene.marker).inverse() * scene.camera.world_from_camera;
  }

  Eigen::Vector3f albedo(const RayHit& hit, const Eigen::Vector3d& direction) const override {
    if (!picture_) return rgb_;
    const Eigen::Vector3d point = marker_from_camera_ * (hit.depth_m * direction);
    if (point.head<2>().cwiseAbs().maxCoeff() > picture_->paperSide()) return rgb_;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int row = 0; row < kPaperSamples; ++row) {
      for (int col = 0; col < kPaperSamples; ++col) {
        const double du = (col + 0.5) / kPaperSamples - 0.5;
        const double dv = (row + 0.5) / kPaperSamples - 0.5;
        sum += ink(direction + Eigen::Vector3d(du / pinhole_.fx_px, dv / pinhole_.fy_px, 0.0));
      }
    }
    return sum / static_cast<float>(kPaperSamples * kPaperSamples);
  }

 private:
  Eigen::Vector3f ink(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d ray = marker_from_camera_.linear() * direction;
    const Eigen::Vector3d eye = marker_from_camera_.translation();
    const Eigen::Vector3d point = eye - ray * (eye.z() / ray.z());
    const std::optional<bool> white = picture_->isWhite(point.x(), point.y());
    return white ? Eigen::Vector3f::Constant(*white ? kWhiteInk : kBlackInk) : rgb_;
  }

  Eigen::Vector3f rgb_;
  Pinhole pinhole_;
  std::optional<MarkerPicture> picture_;
  Pose marker_from_camera_ = Pose::Identity();
};

class BoxSurface : public Surface {
 public:
  BoxSurface(const SceneBox& box, const Pose& camera_from_box)
      : labels_(box.labels), box_from_camera_(camera_from_box.inverse()) {
    for (std::size_t face = 0; face < face_rgb_.size(); ++face) {
      const std::uint32_t rgb = face < kFlapFace ? box.face_rgb[face].value_or(box.rgb) : box.rgb;
      face_rgb_[face] = toVector(rgb);
    }
  }

  Eigen::Vector3f albedo(const RayHit& hit, const Eigen::Vector3d& direction) const override {
    Eigen::Vector3f rgb = face_rgb_[hit.face];
    if (labels_.empty() || hit.face == kFlapFace) return rgb;
    const bool is_top = hit.face == static_cast<std::uint8_t>(BoxFace::kTop);
    const Eigen::Vector2d point = (box_from_camera_ * (hit.depth_m * direction)).head<2>();
    for (const BoxLabel& label : labels_) {
      const Eigen::Vector2d from_center = (point - label.center_m).cwiseAbs();
      const bool inside = ((from_center - 0.5 * label.size_m).array() <= kLabelTolerance).all();
      if (inside && (is_top || label.down_sides)) rgb = toVector(label.rgb);
    }
    return rgb;
  }

 private:
  std::array<Eigen::Vector3f, kFlapFace + 1> face_rgb_;
  std::vector<BoxLabel> labels_;
  Pose box_from_camera_;
};

Mesh floorMesh(const Floor& floor, const Pose& camera_from_world) {
  const double x = 0.5 * floor.size_x_m;
  const double y = 0.5 * floor.size_y_m;
  Mesh mesh;
  addQuad(mesh, camera_from_world,
          {Eigen::Vector3d(-x, -y, 0), Eigen::Vector3d(x, -y, 0), Eigen::Vector3d(x, y, 0),
           Eigen::Vector3d(-x, y, 0)},
          0);
  return mesh;
}

}  // namespace

std::vector<SceneObject> buildObjects(const Scene& scene) {
  const Pose camera_from_world = scene.camera.world_from_camera.inverse();
  std::vector<SceneObject> objects;
  objects.push_back({floorMesh(scene.floor, camera_from_world), std::make_unique<FloorSurface>(scene)});
  for (const SceneBox& box : scene.boxes) {
    const Pose camera_from_box = camera_from_world * worldFromBox(box);
    objects.push_back({boxMesh(box, camera_from_box), std::make_unique<BoxSurface>(box, camera_from_box)});
  }
  return objects;
}

std::vector<Eigen::Vector3d> topCorners(const SceneBox& box, const Pose& camera_from_world) {
  const Pose camera_from_box = camera_from_world * worldFromBox(box);
  std::vector<Eigen::Vector3d> corners;
  // The outer half of a rounded edge is more a side than the top.
  const Eigen::Array2d inset = Eigen::Array2d::Constant((1.0 - std::sqrt(0.5)) * box.shape.rounding_m);
  const Eigen::Array2d share = 1.0 - 2.0 * inset / box.size_m.head<2>().array();
  for (Eigen::Vector3d corner : faceCorners(box, BoxFace::kTop)) {
    corner.head<2>().array() *= share;
    corners.push_back(camera_from_box * corner);
  }
  return corners;
}

}  // namespace mixed_palletizing::simulation
