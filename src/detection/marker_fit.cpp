#include "marker_fit.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <opencv2/core.hpp>

#include "gray_step.hpp"

namespace mixed_palletizing::detection {
namespace {

constexpr double kSquareTolerance =
    0.12;                          // of the side: OpenCV's corners of a small marker, a floor not quite even
constexpr int kRounds = 4;         // of looking for the steps
constexpr int kReweighings = 6;    // within a round
constexpr double kEndShare = 0.2;  // of an edge: near its ends other edges disturb
constexpr double kReachCells = 0.35;   // how far across an edge the step is looked for
constexpr double kLeastReach = 1.0;    // [px]
constexpr double kLargestReach = 8.0;  // [px]
constexpr std::size_t kMinPlaces = 24;
constexpr double kTukey = 4.685;
constexpr double kNormalMedian = 0.6745;
constexpr double kSmallestScale = 0.05;  // of a pixel: the robust spread is not taken for smaller

Eigen::Vector2d turned(double yaw_rad, const Eigen::Vector2d& v) {
  return {std::cos(yaw_rad) * v.x() - std::sin(yaw_rad) * v.y(),
          std::sin(yaw_rad) * v.x() + std::cos(yaw_rad) * v.y()};
}

/// A boundary between two cells in the marker's frame, whose unit is its side: x to the right, y up in the picture.
struct CellEdge {
  Eigen::Vector2d begin;
  Eigen::Vector2d end;
  Eigen::Vector2d normal;  // +x or +y
  double rise;             // +1: brighter on the normal's side
};

std::vector<CellEdge> cellEdges(const std::vector<bool>& white, int cells) {
  std::vector<CellEdge> edges;
  // Around the border (black) is the quiet zone (white).
  const auto isWhite = [&](int row, int col) {
    if (row < 0 || col < 0 || row >= cells || col >= cells) return true;
    return static_cast<bool>(white[static_cast<std::size_t>(row * cells + col)]);
  };
  const auto place = [&](int line) { return static_cast<double>(line) / cells - 0.5; };
  for (int line = 0; line <= cells; ++line) {
    for (int k = 0; k < cells; ++k) {
      if (isWhite(k, line - 1) != isWhite(k, line)) {
        edges.push_back({{place(line), -place(k)},
                         {place(line), -place(k + 1)},
                         Eigen::Vector2d::UnitX(),
                         isWhite(k, line) ? 1.0 : -1.0});
      }
      if (isWhite(line - 1, k) != isWhite(line, k)) {
        edges.push_back({{place(k), -place(line)},
                         {place(k + 1), -place(line)},
                         Eigen::Vector2d::UnitY(),
                         isWhite(line - 1, k) ? 1.0 : -1.0});
      }
    }
  }
  return edges;
}

/// Where the image has a step, beside where the marker has it: residual [m] along the normal, and its derivatives.
struct Place {
  double residual_m;
  Eigen::Vector4d gain;  // of centre x, y (marker's frame), yaw, relative side
  double weight;
};

/// A half of the contrast that the pixels around the marker's middle have.
double leastRise(const cv::Mat& gray, const PlaneMap& map, const PlaneMarker& marker) {
  std::vector<double> values;
  constexpr int kGrid = 24;
  for (int i = 0; i <= kGrid; ++i) {
    for (int k = 0; k <= kGrid; ++k) {
      const Eigen::Vector2d at(static_cast<double>(i) / kGrid - 0.5, static_cast<double>(k) / kGrid - 0.5);
      const auto pixel = map.pixel(marker.center + turned(marker.yaw_rad, marker.side_m * at));
      if (!pixel) continue;
      const cv::Point p(static_cast<int>(std::lround(pixel->x())), static_cast<int>(std::lround(pixel->y())));
      if (p.x >= 0 && p.y >= 0 && p.x < gray.cols && p.y < gray.rows)
        values.push_back(gray.at<std::uint8_t>(p));
    }
  }
  if (values.empty()) return 255.0;
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
  };
  return 0.5 * (at(0.9) - at(0.1));
}

/// Adds the places of one edge; `pixel_m` collects the size of a pixel on the plane.
void collect(const cv::Mat& gray, const PlaneMap& map, const PlaneMarker& marker, const CellEdge& edge,
             int cells, double least_rise, double sign, std::vector<Place>& places, double& pixel_m) {
  const auto onPlane = [&](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(marker.center + turned(marker.yaw_rad, marker.side_m * p));
  };
  const auto a = map.pixel(onPlane(edge.begin));
  const auto b = map.pixel(onPlane(edge.end));
  if (!a || !b) return;
  const int steps = std::max(2, static_cast<int>((*b - *a).norm() * (1.0 - 2.0 * kEndShare)));
  for (int i = 0; i <= steps; ++i) {
    const double share = kEndShare + (1.0 - 2.0 * kEndShare) * i / steps;
    const Eigen::Vector2d p = edge.begin + share * (edge.end - edge.begin);
    const auto here = map.pixel(onPlane(p));
    const auto across = map.pixel(onPlane(p + edge.normal / cells));
    if (!here || !across) return;
    const double cell_px = (*across - *here).norm();
    const double reach = std::clamp(kReachCells * cell_px, kLeastReach, kLargestReach);
    const Eigen::Vector2d direction = (*across - *here) / cell_px;
    const auto step = findGrayStep(gray, *here, direction, reach);
    if (!step || step->rise * edge.rise * sign < least_rise) continue;
    const auto found = map.point(*here + step->place_px * direction);
    if (!found) continue;
    const Eigen::Vector2d q = turned(-marker.yaw_rad, *found - marker.center) / marker.side_m;
    const Eigen::Vector2d arm = marker.side_m * p;
    places.push_back(
        {marker.side_m * (q - p).dot(edge.normal),
         Eigen::Vector4d(edge.normal.x(), edge.normal.y(),
                         edge.normal.dot(Eigen::Vector2d(-arm.y(), arm.x())), edge.normal.dot(arm)),
         1.0});
    pixel_m = marker.side_m / cells / cell_px;
  }
}

/// Tukey-weighted least squares; returns (dx, dy, dyaw, relative side).
Eigen::Vector4d solve(std::vector<Place>& places, double smallest_scale_m) {
  Eigen::Vector4d x = Eigen::Vector4d::Zero();
  std::vector<double> sizes(places.size());
  for (int i = 0; i < kReweighings; ++i) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (const Place& p : places) {
      normal += p.weight * p.gain * p.gain.transpose();
      right += p.weight * p.residual_m * p.gain;
    }
    x = normal.ldlt().solve(right);
    for (std::size_t k = 0; k < places.size(); ++k)
      sizes[k] = std::abs(places[k].residual_m - places[k].gain.dot(x));
    std::vector<double> sorted = sizes;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double reach = kTukey * std::max(smallest_scale_m, *middle / kNormalMedian);
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double u = sizes[k] / reach;
      places[k].weight = u < 1.0 ? (1.0 - u * u) * (1.0 - u * u) : 0.0;
    }
  }
  return x;
}

double weightedRms(const std::vector<Place>& places, const Eigen::Vector4d& x) {
  double sum = 0.0;
  double weights = 0.0;
  for (const Place& p : places) {
    const double r = p.residual_m - p.gain.dot(x);
    sum += p.weight * r * r;
    weights += p.weight;
  }
  return std::sqrt(sum / std::max(weights, 1e-9));
}

}  // namespace

std::array<Eigen::Vector2d, 4> PlaneMarker::corners() const {
  constexpr std::array<std::array<double, 2>, 4> kOrder{{{-0.5, 0.5}, {0.5, 0.5}, {0.5, -0.5}, {-0.5, -0.5}}};
  std::array<Eigen::Vector2d, 4> result;
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = center + turned(yaw_rad, side_m * Eigen::Vector2d(kOrder[i][0], kOrder[i][1]));
  }
  return result;
}

std::optional<PlaneMarker> placeMarker(const PlaneMap& map, const PixelMarker& marker) {
  std::array<Eigen::Vector2d, 4> corners;
  PlaneMarker placed;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto corner = map.point(marker.corners_px[i]);
    if (!corner) return std::nullopt;
    corners[i] = *corner;
    placed.center += 0.25 * *corner;
  }
  Eigen::Vector2d along = Eigen::Vector2d::Zero();  // all four edges turned onto the first
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d edge = corners[(i + 1) % 4] - corners[i];
    along += 0.25 * turned(static_cast<double>(i) * M_PI / 2, edge);
  }
  placed.yaw_rad = std::atan2(along.y(), along.x());
  placed.side_m = along.norm();
  const auto square = placed.corners();
  for (std::size_t i = 0; i < 4; ++i) {
    if (!((square[i] - corners[i]).norm() < kSquareTolerance * placed.side_m)) return std::nullopt;
  }
  return placed;
}

void fitMarker(const cv::Mat& gray, const PlaneMap& map, const std::vector<bool>& white, bool inverted,
               PlaneMarker& marker) {
  const int cells = static_cast<int>(std::lround(std::sqrt(static_cast<double>(white.size()))));
  const std::vector<CellEdge> edges = cellEdges(white, cells);
  PlaneMarker fitted = marker;
  for (int round = 0; round < kRounds; ++round) {
    const double least_rise = leastRise(gray, map, fitted);
    std::vector<Place> places;
    double pixel_m = 0.0;
    for (const CellEdge& edge : edges) {
      collect(gray, map, fitted, edge, cells, least_rise, inverted ? -1.0 : 1.0, places, pixel_m);
    }
    if (places.size() < kMinPlaces) return;
    const Eigen::Vector4d x = solve(places, kSmallestScale * pixel_m);
    if (!x.allFinite() || std::abs(x(3)) > kSquareTolerance) return;
    fitted.rms_m = weightedRms(places, x);
    fitted.places = places.size();
    fitted.center += turned(fitted.yaw_rad, x.head<2>());
    fitted.yaw_rad += x(2);
    fitted.side_m *= 1.0 + x(3);
  }
  marker = fitted;
}

}  // namespace mixed_palletizing::detection
