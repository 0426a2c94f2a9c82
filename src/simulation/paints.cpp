#include "paints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <mixed_palletizing/simulation/pinhole.hpp>

#include "box_mesh.hpp"
#include "printed_board.hpp"

namespace mixed_palletizing::simulation {
namespace {

using geometry::Pose;

constexpr float kWhiteInk = 240.0f;
constexpr float kBlackInk = 16.0f;

/// Rays a pixel of printed paper is averaged over, along a row and a column: printed edges then look as smooth as
/// to a real image sensor.
constexpr int kPaperSamples = 4;

/// Of the angle between a ray and the normal, beyond which a pixel's reach on the surface counts no further.
constexpr double kLeastCosine = 0.01;

/// A label that ends at a box's edge reaches its side [m].
constexpr double kLabelTolerance = 1e-6;

Eigen::Vector3f toVector(std::uint32_t rgb) {
  return Eigen::Vector3f(static_cast<float>((rgb >> 16) & 0xffu), static_cast<float>((rgb >> 8) & 0xffu),
                         static_cast<float>(rgb & 0xffu));
}

class PlainPaint : public Paint {
 public:
  explicit PlainPaint(std::uint32_t rgb) : rgb_(toVector(rgb)) {}
  Eigen::Vector3f albedo(const RayHit&, const Eigen::Vector3d&) const override { return rgb_; }

 private:
  Eigen::Vector3f rgb_;
};

class SurfacePaint : public Paint {
 public:
  SurfacePaint(const Scene& scene, const SceneSurface& surface)
      : rgb_(toVector(surface.rgb)),
        texture_(surface.texture),
        size_(surface.size_m),
        pinhole_(scene.camera),
        surface_from_camera_(surface.world_from_surface.inverse() * scene.camera.world_from_camera) {
    if (surface.name.empty() && scene.has_marker) add({scene.marker, 1, 1, 0.0});
    for (const Marker& marker : scene.markers) {
      if (marker.surface == surface.name) add({marker, 1, 1, 0.0});
    }
    for (const MarkerBoard& board : scene.boards) {
      if (board.first.surface == surface.name) add(board);
    }
  }

  Eigen::Vector3f albedo(const RayHit& hit, const Eigen::Vector3d& direction) const override {
    if (hit.face != 0 || surface_from_camera_.translation().z() <= 0.0) return rgb_;  // from below
    if (prints_.empty() && !texture_) return rgb_;
    const Eigen::Vector3d ray = surface_from_camera_.linear() * direction;
    const Eigen::Vector2d place = surface_from_camera_.translation().head<2>() + hit.depth_m * ray.head<2>();
    const double pixel = hit.depth_m / std::min(pinhole_.fx_px, pinhole_.fy_px);
    const double reach = pixel * ray.norm() / std::max(kLeastCosine, std::abs(ray.z()) / ray.norm());
    if (!nearPrint(place, reach)) return ground(place);
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
  struct Print {
    PrintedBoard picture;
    Pose print_from_surface;
  };

  void add(const MarkerBoard& board) {
    prints_.push_back({PrintedBoard(board), worldFromMarker(board.first).inverse()});
  }

  /// Whether a pixel that shows what is within `reach` of the place may show paper.
  bool nearPrint(const Eigen::Vector2d& place, double reach) const {
    for (const Print& print : prints_) {
      const Eigen::Vector3d own = print.print_from_surface * Eigen::Vector3d(place.x(), place.y(), 0.0);
      const Eigen::Array2d half = 0.5 * print.picture.paperSize().array() + reach;
      if ((own.head<2>().array().abs() <= half).all()) return true;
    }
    return false;
  }

  Eigen::Vector3f ground(const Eigen::Vector2d& place) const {
    if (!texture_) return rgb_;
    return texture_->at(place.x() / size_.x() + 0.5, 0.5 - place.y() / size_.y());
  }

  Eigen::Vector3f ink(const Eigen::Vector3d& direction) const {
    const Eigen::Vector3d ray = surface_from_camera_.linear() * direction;
    const Eigen::Vector3d eye = surface_from_camera_.translation();
    const Eigen::Vector3d point = eye - ray * (eye.z() / ray.z());
    for (std::size_t i = prints_.size(); i-- > 0;) {  // a later one lies over an earlier one
      const Eigen::Vector3d own = prints_[i].print_from_surface * point;
      const std::optional<bool> white = prints_[i].picture.isWhite(own.x(), own.y());
      if (white) return Eigen::Vector3f::Constant(*white ? kWhiteInk : kBlackInk);
    }
    return ground(point.head<2>());
  }

  Eigen::Vector3f rgb_;
  std::shared_ptr<const Texture> texture_;
  Eigen::Vector2d size_;
  Pinhole pinhole_;
  Pose surface_from_camera_;
  std::vector<Print> prints_;
};

/// Place on a face of a box from the picture's left and from its top, as shares of its size.
Eigen::Vector2d faceShare(BoxFace face, const Eigen::Vector3d& share) {
  switch (face) {
    case BoxFace::kMinusX:
      return {0.5 - share.y(), 0.5 - share.z()};
    case BoxFace::kPlusX:
      return {0.5 + share.y(), 0.5 - share.z()};
    case BoxFace::kMinusY:
      return {0.5 + share.x(), 0.5 - share.z()};
    case BoxFace::kPlusY:
      return {0.5 - share.x(), 0.5 - share.z()};
    case BoxFace::kBottom:
      return {0.5 - share.x(), 0.5 - share.y()};
    case BoxFace::kTop:
      break;
  }
  return {0.5 + share.x(), 0.5 - share.y()};
}

class BoxPaint : public Paint {
 public:
  BoxPaint(const SceneBox& box, const Pose& camera_from_box)
      : textures_(box.face_texture),
        labels_(box.labels),
        size_(box.size_m),
        box_from_camera_(camera_from_box.inverse()) {
    for (std::size_t face = 0; face < face_rgb_.size(); ++face) {
      const std::uint32_t rgb = face < kFlapFace ? box.face_rgb[face].value_or(box.rgb) : box.rgb;
      face_rgb_[face] = toVector(rgb);
    }
    for (const auto& texture : textures_) is_plain_ = is_plain_ && !texture;
    is_plain_ = is_plain_ && labels_.empty();
  }

  Eigen::Vector3f albedo(const RayHit& hit, const Eigen::Vector3d& direction) const override {
    Eigen::Vector3f rgb = face_rgb_[hit.face];
    if (is_plain_ || hit.face == kFlapFace) return rgb;
    const Eigen::Vector3d point = box_from_camera_ * (hit.depth_m * direction);
    if (textures_[hit.face]) {
      const Eigen::Vector2d share = faceShare(static_cast<BoxFace>(hit.face), point.cwiseQuotient(size_));
      rgb = textures_[hit.face]->at(share.x(), share.y());
    }
    const bool is_top = hit.face == static_cast<std::uint8_t>(BoxFace::kTop);
    for (const BoxLabel& label : labels_) {
      const Eigen::Vector2d from_center = (point.head<2>() - label.center_m).cwiseAbs();
      const bool inside = ((from_center - 0.5 * label.size_m).array() <= kLabelTolerance).all();
      if (inside && (is_top || label.down_sides)) rgb = toVector(label.rgb);
    }
    return rgb;
  }

 private:
  std::array<Eigen::Vector3f, kFlapFace + 1> face_rgb_;
  std::array<std::shared_ptr<const Texture>, 6> textures_;
  std::vector<BoxLabel> labels_;
  Eigen::Vector3d size_;
  Pose box_from_camera_;
  bool is_plain_ = true;
};

}  // namespace

std::unique_ptr<Paint> plainPaint(std::uint32_t rgb) { return std::make_unique<PlainPaint>(rgb); }

std::unique_ptr<Paint> surfacePaint(const Scene& scene, const SceneSurface& surface) {
  return std::make_unique<SurfacePaint>(scene, surface);
}

std::unique_ptr<Paint> boxPaint(const SceneBox& box, const Pose& camera_from_box) {
  return std::make_unique<BoxPaint>(box, camera_from_box);
}

}  // namespace mixed_palletizing::simulation
