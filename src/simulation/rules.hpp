// The rules that scenes must keep.
#pragma once

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <mixed_palletizing/simulation/scene.hpp>

namespace mixed_palletizing::simulation {

constexpr double kMaxLength = 100.0;  // [m]: a larger number is a length in millimetres

/// Collects broken rules.
class Rules {
 public:
  template <typename T>
  void require(bool holds, const std::string& key, const T& value, const std::string& rule) {
    if (holds) return;
    std::ostringstream line;
    line << key << ": " << value << " " << rule;
    lines_.push_back(line.str());
  }
  void length(const std::string& key, double value) {
    require(value > 0.0 && value <= kMaxLength, key, value, "is not a length in (0, 100] m");
  }
  template <typename Vector>
  void lengths(const std::string& key, const Vector& value) {
    const bool holds = (value.array() > 0.0).all() && (value.array() <= kMaxLength).all();
    require(holds, key, value.transpose(), "are not lengths in (0, 100] m");
  }
  template <typename Vector>
  void place(const std::string& key, const Vector& value) {
    require((value.array().abs() <= kMaxLength).all(), key, value.transpose(), "is not a place within 100 m");
  }
  void angle(const std::string& key, double value) {
    require(std::isfinite(value), key, value, "is not an angle");
  }
  void ratio(const std::string& key, double value) {
    require(value >= 0.0 && value <= 1.0, key, value, "is not in [0, 1]");
  }
  void color(const std::string& key, std::uint32_t value) {
    require(value <= 0xffffffu, key, value, "is not a colour 0xRRGGBB");
  }
  void pose(const std::string& key, const geometry::Pose& value) {
    const Eigen::Matrix3d rotation = value.linear();
    const bool rigid = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-6 &&
                       rotation.determinant() > 0.0;
    if (!rigid) add(key, "its rotation is none");
    place(key, value.translation());
  }
  void add(const std::string& key, const std::string& what) { lines_.push_back(key + ": " + what); }

  bool empty() const { return lines_.empty(); }
  const std::vector<std::string>& lines() const { return lines_; }

 private:
  std::vector<std::string> lines_;
};

void checkBox(const SceneBox& box, const std::string& key, Rules& rules);
void checkSurface(const SceneSurface& surface, const std::string& key, Rules& rules);
void checkObject(const SceneObject& object, const std::string& key, Rules& rules);

/// Boxes that overlap, and what holds the camera; for scenes that keep all other rules.
void checkSolids(const Scene& scene, Rules& rules);

}  // namespace mixed_palletizing::simulation
