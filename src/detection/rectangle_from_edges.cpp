#include "rectangle_from_edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <mixed_palletizing/geometry/line2d.hpp>
#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {
namespace {

using geometry::Line2d;
using geometry::Rectangle;

// An edge belongs to a side when it differs from the side's direction by less than this [rad].
constexpr double kSideTolerance = 0.26;

double directionOf(const Edge& edge) { return std::atan2(edge.along().y(), edge.along().x()); }

Line2d lineOf(const Edge& edge) { return Line2d::through(edge.from, edge.to); }

/// Centre by the mean lines of opposite edges, sizes by eq. 4.1 and 4.2.
std::optional<Rectangle> fromFourSides(const EdgeSides& sides, double yaw_rad) {
  Rectangle rectangle;
  rectangle.yaw_rad = yaw_rad;
  const auto center = intersection(meanLine(lineOf(*sides[0]), lineOf(*sides[2])),
                                   meanLine(lineOf(*sides[1]), lineOf(*sides[3])));
  if (!center) return std::nullopt;
  rectangle.center = *center;
  const Line2d along = Line2d::through(*center, *center + rectangle.axisX());
  const Line2d across = Line2d::through(*center, *center + rectangle.axisY());
  const auto left = intersection(lineOf(*sides[3]), along);
  const auto right = intersection(lineOf(*sides[1]), along);
  const auto low = intersection(lineOf(*sides[0]), across);
  const auto high = intersection(lineOf(*sides[2]), across);
  if (!left || !right || !low || !high) return std::nullopt;
  rectangle.size = Eigen::Vector2d((*right - *left).norm(), (*high - *low).norm());
  return rectangle;
}

/// Found sides where their edges lie, the others where the hull ends.
Rectangle fromSomeSides(const EdgeSides& sides, const geometry::Polygon& hull, double yaw_rad) {
  Rectangle rectangle;
  rectangle.yaw_rad = yaw_rad;
  const std::array<Eigen::Vector2d, 4> outward{-rectangle.axisY(), rectangle.axisX(), rectangle.axisY(),
                                               -rectangle.axisX()};
  std::array<double, 4> reach{};
  for (std::size_t i = 0; i < 4; ++i) {
    if (sides[i]) {
      reach[i] = outward[i].dot(0.5 * (sides[i]->from + sides[i]->to));
      continue;
    }
    reach[i] = -INFINITY;
    for (const Eigen::Vector2d& corner : hull) reach[i] = std::max(reach[i], outward[i].dot(corner));
  }
  rectangle.size = Eigen::Vector2d(reach[1] + reach[3], reach[0] + reach[2]);
  rectangle.center =
      0.5 * (reach[1] - reach[3]) * rectangle.axisX() + 0.5 * (reach[2] - reach[0]) * rectangle.axisY();
  return rectangle;
}

}  // namespace

EdgeSides pickSides(const std::vector<Edge>& edges) {
  const auto longest = std::max_element(edges.begin(), edges.end(),
                                        [](const Edge& a, const Edge& b) { return a.length() < b.length(); });
  const double reference = directionOf(*longest);
  EdgeSides sides;
  for (const Edge& edge : edges) {
    const double turn = directionOf(edge) - reference;
    if (std::abs(geometry::foldQuarterTurn(turn)) > kSideTolerance) continue;
    const long quarter = std::lround(turn / (M_PI / 2));
    std::optional<Edge>& side = sides[static_cast<std::size_t>(((quarter % 4) + 4) % 4)];
    if (!side || side->length() < edge.length()) side = edge;
  }
  return sides;
}

double medianYaw(const EdgeSides& sides) {
  const double reference = directionOf(*sides[0]);
  std::vector<double> turns;
  for (const auto& side : sides) {
    if (side) turns.push_back(geometry::foldQuarterTurn(directionOf(*side) - reference));
  }
  std::sort(turns.begin(), turns.end());
  const std::size_t half = turns.size() / 2;
  return reference + (turns.size() % 2 == 1 ? turns[half] : 0.5 * (turns[half - 1] + turns[half]));
}

EdgeRectangle rectangleFromEdges(const geometry::Polygon& hull, const std::vector<Edge>& edges) {
  EdgeRectangle result;
  if (edges.empty()) {
    result.rectangle = geometry::minimumAreaRectangle(hull);
    return result;
  }
  const EdgeSides sides = pickSides(edges);
  for (std::size_t i = 0; i < 4; ++i) result.side_found[i] = sides[i].has_value();
  const double yaw = medianYaw(sides);
  if (std::all_of(result.side_found.begin(), result.side_found.end(), [](bool found) { return found; })) {
    if (const auto rectangle = fromFourSides(sides, yaw)) {
      result.rectangle = *rectangle;
      return result;
    }
  }
  result.rectangle = fromSomeSides(sides, hull, yaw);
  return result;
}

}  // namespace mixed_palletizing::detection
