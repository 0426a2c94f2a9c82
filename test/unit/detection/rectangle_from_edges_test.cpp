#include "rectangle_from_edges.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include <mixed_palletizing/geometry/pose.hpp>

namespace mixed_palletizing::detection {
namespace {

using geometry::Polygon;
using geometry::Rectangle;

Rectangle randomRectangle(std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Rectangle r;
  r.center = Eigen::Vector2d(uniform(rng) - 0.5, uniform(rng) - 0.5);
  r.yaw_rad = 7.0 * uniform(rng);
  r.size = Eigen::Vector2d(0.15 + 0.4 * uniform(rng), 0.15 + 0.4 * uniform(rng));
  return r;
}

/// Edges on the middle parts of the sides, beginning anywhere.
std::vector<Edge> edgesOf(const Rectangle& r, std::mt19937& rng) {
  const auto c = r.corners();
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    const Eigen::Vector2d side = c[(i + 1) % 4] - c[i];
    edges.push_back({c[i] + 0.1 * side, c[i] + 0.85 * side});
  }
  std::rotate(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(rng() % 4), edges.end());
  return edges;
}

void expectSame(const Rectangle& a, const Rectangle& b, double tolerance, int i) {
  const Rectangle p = a.lengthFirst();
  const Rectangle q = b.lengthFirst();
  EXPECT_LT((p.center - q.center).norm(), tolerance) << "case " << i;
  EXPECT_LT((p.size - q.size).norm(), tolerance) << "case " << i;
  EXPECT_LT(std::abs(geometry::foldQuarterTurn(p.yaw_rad - q.yaw_rad)), 10.0 * tolerance) << "case " << i;
}

TEST(RectangleFromEdges, isExactForExactEdges) {
  std::mt19937 rng(61);
  for (int i = 0; i < 300; ++i) {
    const Rectangle r = randomRectangle(rng);
    const auto corners = r.corners();
    const auto found = rectangleFromEdges(Polygon(corners.begin(), corners.end()), edgesOf(r, rng));
    expectSame(found.rectangle, r, 1e-9, i);
    for (const bool side : found.side_found) EXPECT_TRUE(side);
  }
}

TEST(RectangleFromEdges, usesTheHullWhereAnEdgeIsMissing) {
  std::mt19937 rng(62);
  for (int i = 0; i < 300; ++i) {
    const Rectangle r = randomRectangle(rng);
    const auto corners = r.corners();
    auto edges = edgesOf(r, rng);
    const std::size_t removed = 1 + rng() % 4;
    edges.resize(4 - removed);
    const auto found = rectangleFromEdges(Polygon(corners.begin(), corners.end()), edges);
    expectSame(found.rectangle, r, 1e-9, i);
    EXPECT_EQ(static_cast<std::size_t>(std::count(found.side_found.begin(), found.side_found.end(), true)),
              4 - removed)
        << "seed 62, case " << i;
  }
}

TEST(RectangleFromEdges, ignoresEdgesAcrossACorner) {
  std::mt19937 rng(63);
  const Rectangle r = randomRectangle(rng);
  const auto c = r.corners();
  auto edges = edgesOf(r, rng);
  edges.push_back({c[1] + 0.2 * (c[0] - c[1]), c[1] + 0.2 * (c[2] - c[1])});
  expectSame(rectangleFromEdges(Polygon(c.begin(), c.end()), edges).rectangle, r, 1e-9, 0);
}

TEST(RectangleFromEdges, refusesAHullWithoutArea) {
  EXPECT_THROW(rectangleFromEdges({{0, 0}, {1, 0}}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace mixed_palletizing::detection
