#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <mixed_palletizing/detection/work_region.hpp>

namespace mixed_palletizing::detection {
namespace {

constexpr double kSmallestArea_m2 = 1e-4;
constexpr double kLargestZ_m = 20.0;

geometry::Polygon polygonOf(const std::vector<double>& flat) {
  geometry::Polygon polygon;
  for (std::size_t i = 0; i + 1 < flat.size(); i += 2) polygon.emplace_back(flat[i], flat[i + 1]);
  return polygon;
}

/// Even-odd rule: the sides that a ray along x crosses.
bool inside(const std::vector<Eigen::Vector2f>& polygon, float x, float y) {
  bool is_inside = false;
  for (std::size_t i = 0, k = polygon.size() - 1; i < polygon.size(); k = i++) {
    const Eigen::Vector2f& a = polygon[i];
    const Eigen::Vector2f& b = polygon[k];
    if ((a.y() > y) == (b.y() > y)) continue;
    if (x < a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace

std::vector<std::string> problems(const RegionOptions& options) {
  std::vector<std::string> lines;
  const auto& flat = options.polygon_m;
  const bool finite = std::all_of(flat.begin(), flat.end(), [](double v) { return std::isfinite(v); });
  if (flat.size() % 2 != 0 || (!flat.empty() && flat.size() < 6)) {
    lines.push_back("polygon_m: " + std::to_string(flat.size()) +
                    " numbers are no corners: x and y of at least three are needed");
  } else if (!finite) {
    lines.push_back("polygon_m: a corner is not finite");
  } else if (!flat.empty() && !(std::abs(geometry::signedArea(polygonOf(flat))) > kSmallestArea_m2)) {
    lines.push_back("polygon_m: the corners enclose no area");
  }
  if (!(options.min_z_m < options.max_z_m) || !(std::abs(options.min_z_m) <= kLargestZ_m) ||
      !(std::abs(options.max_z_m) <= kLargestZ_m)) {
    lines.push_back("max_z_m: " + std::to_string(options.max_z_m) + " must be more than min_z_m, " +
                    std::to_string(options.min_z_m) + ", and both within 20 m of the floor");
  }
  for (const geometry::Plane& plane : options.planes) {
    if (!(std::abs(plane.normal.norm() - 1.0) < 1e-3) || !std::isfinite(plane.offset)) {
      lines.push_back("planes: a normal is not of length 1, or an offset is not finite");
    }
  }
  if (!(options.plane_distance_m > 0.0) || !(options.plane_distance_m <= 1.0)) {
    lines.push_back("plane_distance_m: " + std::to_string(options.plane_distance_m) +
                    " must lie between 0 and 1");
  }
  return lines;
}

WorkRegion::WorkRegion(const RegionOptions& options) {
  std::string message;
  for (const std::string& line : problems(options)) message += "\n  " + line;
  if (!message.empty()) throw std::invalid_argument("WorkRegion: options:" + message);
  const RegionOptions everywhere;
  limited_ = !options.polygon_m.empty() || !options.planes.empty() || options.min_z_m > everywhere.min_z_m ||
             options.max_z_m < everywhere.max_z_m;
  min_z_m_ = static_cast<float>(options.min_z_m);
  max_z_m_ = static_cast<float>(options.max_z_m);
  plane_distance_m_ = static_cast<float>(options.plane_distance_m);
  for (const Eigen::Vector2d& corner : polygonOf(options.polygon_m)) polygon_.push_back(corner.cast<float>());
  for (const geometry::Plane& plane : options.planes) {
    planes_.emplace_back((Eigen::Vector4d() << plane.normal, plane.offset).finished().cast<float>());
  }
}

bool WorkRegion::contains(const Eigen::Vector3f& point) const {
  if (!(point.z() >= min_z_m_ && point.z() <= max_z_m_)) return false;
  if (!polygon_.empty() && !inside(polygon_, point.x(), point.y())) return false;
  return std::none_of(planes_.begin(), planes_.end(), [&](const Eigen::Vector4f& plane) {
    return std::abs(plane.head<3>().dot(point) + plane.w()) < plane_distance_m_;
  });
}

}  // namespace mixed_palletizing::detection
