#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <mixed_palletizing/adapters/golden_detections.hpp>

namespace mixed_palletizing::adapters {
namespace {

constexpr double kMmPerM = 1000.0;
constexpr double kDegPerRad = 180.0 / M_PI;

template <typename... Values>
std::string format(const char* pattern, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

std::string describe(const GoldenBox& box) {
  return format("box %.1f x %.1f x %.1f mm at (%.1f, %.1f, %.1f) mm", kMmPerM * box.size.x(),
                kMmPerM * box.size.y(), kMmPerM * box.size.z(), kMmPerM * box.center.x(),
                kMmPerM * box.center.y(), kMmPerM * box.center.z());
}

std::string join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text.empty() ? "none" : text;
}

/// Difference of two directions that are the same after a turn by pi, [0, pi/2].
double yawDifference(double a, double b) { return std::abs(std::remainder(a - b, M_PI)); }

/// Lines for one pair of boxes.
void compareBoxes(const GoldenBox& golden, const GoldenBox& now, const GoldenTolerances& tolerances,
                  std::vector<std::string>& lines) {
  const double moved = (now.center - golden.center).norm();
  if (!(moved <= tolerances.position_m)) {
    lines.push_back(describe(golden) + format(": moved by %.2f mm", kMmPerM * moved));
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    const char* names[] = {"length", "width", "height"};
    if (!(std::abs(now.size(i) - golden.size(i)) <= tolerances.size_m)) {
      lines.push_back(describe(golden) + format(": %s %.2f mm was %.2f mm", names[i], kMmPerM * now.size(i),
                                                kMmPerM * golden.size(i)));
    }
  }
  const double turned = yawDifference(now.yaw_rad, golden.yaw_rad);
  if (!(turned <= tolerances.yaw_rad)) {
    lines.push_back(describe(golden) + format(": turned by %.3f deg", kDegPerRad * turned));
  }
  if (tolerances.compare_flags && now.flags != golden.flags) {
    lines.push_back(describe(golden) + ": flags " + join(now.flags) + " were " + join(golden.flags));
  }
}

std::vector<std::string> compareClouds(const GoldenCloud& golden, const GoldenCloud& now,
                                       const GoldenTolerances& tolerances) {
  std::vector<std::string> lines;
  if (golden.stamp_ns != now.stamp_ns) lines.push_back("is another cloud: its stamp differs");
  if (golden.fault != now.fault) {
    lines.push_back("fault '" + now.fault + "' was '" + golden.fault + "'");
  }
  std::vector<char> used(now.boxes.size(), 0);
  for (const GoldenBox& box : golden.boxes) {
    double nearest = 0.5 * std::min(box.size.x(), box.size.y());
    int pair = -1;
    for (std::size_t i = 0; i < now.boxes.size(); ++i) {
      const double distance = (now.boxes[i].center - box.center).norm();
      if (!used[i] && distance < nearest) {
        nearest = distance;
        pair = static_cast<int>(i);
      }
    }
    if (pair < 0) {
      lines.push_back("missing: " + describe(box));
      continue;
    }
    used[static_cast<std::size_t>(pair)] = 1;
    compareBoxes(box, now.boxes[static_cast<std::size_t>(pair)], tolerances, lines);
  }
  for (std::size_t i = 0; i < now.boxes.size(); ++i) {
    if (!used[i]) lines.push_back("new: " + describe(now.boxes[i]));
  }
  return lines;
}

void compareBase(const GoldenDetections& golden, const GoldenDetections& now,
                 const GoldenTolerances& tolerances, std::vector<GoldenDifference>& differences) {
  const geometry::Pose change = golden.base_from_camera.inverse() * now.base_from_camera;
  const double moved = change.translation().norm();
  const double turned = Eigen::AngleAxisd(change.linear()).angle();
  if (!(moved <= tolerances.base_m) || !(turned <= tolerances.base_rad)) {
    differences.push_back({-1, format("base frame moved by %.2f mm and turned by %.3f deg", kMmPerM * moved,
                                      kDegPerRad * turned)});
  }
}

}  // namespace

std::vector<std::string> problems(const GoldenTolerances& tolerances) {
  std::vector<std::string> all;
  const auto check = [&](const char* name, double value) {
    if (!(value >= 0.0) || !std::isfinite(value)) all.push_back(format("%s: %g is negative", name, value));
  };
  check("position_m", tolerances.position_m);
  check("size_m", tolerances.size_m);
  check("yaw_rad", tolerances.yaw_rad);
  check("base_m", tolerances.base_m);
  check("base_rad", tolerances.base_rad);
  return all;
}

std::vector<GoldenDifference> compareGolden(const GoldenDetections& golden, const GoldenDetections& now,
                                            const GoldenTolerances& tolerances) {
  std::string mistakes;
  for (const std::string& problem : problems(tolerances)) mistakes += "; " + problem;
  if (!mistakes.empty()) throw std::invalid_argument("compareGolden" + mistakes);
  std::vector<GoldenDifference> differences;
  compareBase(golden, now, tolerances, differences);
  if (golden.clouds.size() != now.clouds.size()) {
    differences.push_back({-1, format("%zu clouds were %zu", now.clouds.size(), golden.clouds.size())});
  }
  for (std::size_t i = 0; i < std::min(golden.clouds.size(), now.clouds.size()); ++i) {
    for (const std::string& line : compareClouds(golden.clouds[i], now.clouds[i], tolerances)) {
      differences.push_back({static_cast<int>(i), line});
    }
  }
  return differences;
}

}  // namespace mixed_palletizing::adapters
