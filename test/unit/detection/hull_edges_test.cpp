#include "hull_edges.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/rectangle.hpp>

namespace mixed_palletizing::detection {
namespace {

using geometry::Polygon;
using geometry::Rectangle;

Rectangle randomRectangle(std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Rectangle r;
  r.center = Eigen::Vector2d(uniform(rng) - 0.5, uniform(rng) - 0.5);
  r.yaw_rad = 7.0 * uniform(rng);
  r.size = Eigen::Vector2d(0.1 + 0.4 * uniform(rng), 0.1 + 0.4 * uniform(rng));
  return r;
}

/// Points on the sides and inside, moved by noise.
std::vector<Eigen::Vector2d> pointsOf(const Rectangle& r, double noise, std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::normal_distribution<double> normal(0.0, noise);
  std::vector<Eigen::Vector2d> points;
  const auto corners = r.corners();
  const auto add = [&](const Eigen::Vector2d& p) {
    points.push_back(p + Eigen::Vector2d(normal(rng), normal(rng)));
  };
  for (std::size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < 300; ++k) {
      const double share = k / 300.0;
      add((1.0 - share) * corners[i] + share * corners[(i + 1) % 4]);
    }
  }
  for (int k = 0; k < 300; ++k) {
    const double u = uniform(rng);
    const double v = uniform(rng);
    add(corners[0] + u * (corners[1] - corners[0]) + v * (corners[3] - corners[0]));
  }
  return points;
}

TEST(ConvexHull, enclosesEveryPointCounterClockwise) {
  std::mt19937 rng(31);
  for (int i = 0; i < 100; ++i) {
    const auto points = pointsOf(randomRectangle(rng), 0.003, rng);
    const Polygon hull = convexHull(points);
    ASSERT_GE(hull.size(), 4u);
    EXPECT_GT(geometry::signedArea(hull), 0.0) << "seed 31, case " << i;
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const Eigen::Vector2d side = hull[(k + 1) % hull.size()] - hull[k];
      for (const Eigen::Vector2d& p : points) {
        const Eigen::Vector2d d = p - hull[k];
        ASSERT_GT(side.x() * d.y() - side.y() * d.x(), -1e-6 * side.norm()) << "seed 31, case " << i;
      }
    }
  }
}

TEST(ConvexHull, isEmptyForPointsWithoutArea) {
  EXPECT_TRUE(convexHull({}).empty());
  EXPECT_TRUE(convexHull({{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE(convexHull({{0, 0}, {1, 1}, {2, 2}, {3, 3}}).empty());
  EXPECT_TRUE(convexHull(std::vector<Eigen::Vector2d>(50, Eigen::Vector2d(0.3, 0.4))).empty());
}

TEST(FindEdges, findsFourEdgesOfNoisyRectanglesWhereverTheHullBegins) {
  std::mt19937 rng(32);
  const TopOptions options;
  for (int i = 0; i < 200; ++i) {
    const Rectangle r = randomRectangle(rng);
    Polygon hull = convexHull(pointsOf(r, 0.0003, rng));
    std::rotate(hull.begin(), hull.begin() + static_cast<std::ptrdiff_t>(rng() % hull.size()), hull.end());
    const auto edges = findEdges(hull, options.min_edge_length_m, options);
    ASSERT_EQ(edges.size(), 4u) << "seed 32, case " << i;
    for (const Edge& edge : edges) {
      const double off = std::remainder(std::atan2(edge.along().y(), edge.along().x()) - r.yaw_rad, M_PI / 2);
      EXPECT_LT(std::abs(off), 0.05) << "seed 32, case " << i;
    }
  }
}

TEST(FindEdges, skipsACutCorner) {
  const TopOptions options;
  const Polygon hull{{0, 0}, {0.3, 0}, {0.3, 0.15}, {0.25, 0.2}, {0, 0.2}};
  EXPECT_EQ(findEdges(hull, options.min_edge_length_m, options).size(), 4u);
}

TEST(FindEdges, ofARoundHullDoNotGrowIntoOne) {
  const TopOptions options;
  Polygon circle;
  for (int k = 0; k < 60; ++k)
    circle.emplace_back(0.2 * std::cos(k * M_PI / 30), 0.2 * std::sin(k * M_PI / 30));
  for (const Edge& edge : findEdges(circle, options.min_edge_length_m, options))
    EXPECT_LT(edge.length(), 0.2);
}

TEST(FindEdges, findsNothingShorterThanTheLimit) {
  EXPECT_TRUE(findEdges({{0, 0}, {0.01, 0}, {0.01, 0.01}, {0, 0.01}}, 0.015, TopOptions()).empty());
  EXPECT_TRUE(findEdges({}, 0.015, TopOptions()).empty());
}

}  // namespace
}  // namespace mixed_palletizing::detection
