#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <mixed_palletizing/detection/base_frame.hpp>
#include <mixed_palletizing/experiments/base_frame_measurement.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace mixed_palletizing::experiments {
namespace {

constexpr double kMillimetres = 1000.0;
constexpr double kDegrees = 180.0 / M_PI;
constexpr int kIds = 30;  // of every dictionary: the smallest has no more
constexpr int kBoardColumns = 4;
constexpr int kBoardRows = 3;
constexpr double kBoardSide = 0.08;  // [m] of its markers
constexpr double kBoardGap = 0.02;   // [m]
constexpr double kLeastSide = 0.10;  // [m] of a single marker
constexpr double kMostSide = 0.20;

void requireDrawable(const BaseFrameViews& views) {
  const auto require = [](bool good, const std::string& what) {
    if (!good) throw std::invalid_argument("measureBaseFrame: views: " + what);
  };
  require(views.max_tilt_rad >= 0.0 && views.max_tilt_rad < M_PI / 2, "max_tilt_rad must lie in [0, pi/2)");
  require(views.min_distance_m > 0.0 && views.max_distance_m >= views.min_distance_m,
          "min_distance_m must be positive and not above max_distance_m");
  require(views.min_depth_stddev_at_1m_m >= 0.0 &&
              views.max_depth_stddev_at_1m_m >= views.min_depth_stddev_at_1m_m,
          "min_depth_stddev_at_1m_m must not be negative nor above max_depth_stddev_at_1m_m");
  require(views.width_px > 0 && views.height_px > 0, "width_px and height_px must be positive");
  require(!views.dictionaries.empty(), "dictionaries must name at least one");
}

/// A view and what the detector is told of it.
struct View {
  simulation::Scene scene;
  detection::DetectionOptions options;
};

View drawView(const BaseFrameViews& views, MarkerKind kind, std::uint64_t seed, std::uint64_t index) {
  std::seed_seq words{seed, seed >> 32, index, index >> 32};
  std::mt19937_64 random(words);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto drawNumber = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
  simulation::Recipe recipe;
  recipe.groups.clear();
  recipe.view.distance_m = {views.min_distance_m, views.max_distance_m};
  recipe.view.tilt_rad = {0.0, views.max_tilt_rad};
  recipe.scene.camera.width_px = views.width_px;
  recipe.scene.camera.height_px = views.height_px;
  recipe.scene.noise.depth_stddev_at_1m_m =
      draw(views.min_depth_stddev_at_1m_m, views.max_depth_stddev_at_1m_m);
  recipe.scene.noise.no_data_on_black = true;
  simulation::Marker marker;
  marker.dictionary =
      views.dictionaries[static_cast<std::size_t>(drawNumber(static_cast<int>(views.dictionaries.size())))];
  marker.inverted = kind == MarkerKind::kBoard ? drawNumber(2) == 1 : kind == MarkerKind::kInverted;
  marker.side_m = draw(kLeastSide, kMostSide);
  marker.id = drawNumber(kIds);
  marker.yaw_rad = draw(-M_PI, M_PI);
  View view;
  view.options.marker.dictionary = marker.dictionary;
  if (kind == MarkerKind::kBoard) {
    marker.side_m = kBoardSide;
    marker.id = 0;
    marker.yaw_rad = 0.0;
    const simulation::MarkerBoard board{marker, kBoardColumns, kBoardRows, kBoardGap};
    recipe.scene.has_marker = false;
    recipe.scene.boards = {board};
    for (const simulation::Marker& m : simulation::markersOf(board)) {
      view.options.marker.board.push_back({m.id, m.position_m.x(), m.position_m.y(), m.yaw_rad});
    }
  } else {
    recipe.scene.marker = marker;
    view.options.marker.id = marker.id;
  }
  view.scene = simulation::recipeScene(recipe, seed, index);
  return view;
}

}  // namespace

const char* toString(MarkerKind kind) {
  switch (kind) {
    case MarkerKind::kNormal:
      return "normal";
    case MarkerKind::kInverted:
      return "inverted";
    case MarkerKind::kBoard:
      break;
  }
  return "board";
}

BaseFrameRecord measureBaseFrame(const BaseFrameViews& views, std::uint64_t seed, std::uint64_t index) {
  requireDrawable(views);
  BaseFrameRecord record;
  record.index = index;
  record.kind = static_cast<MarkerKind>(index % 3);
  const View view = drawView(views, record.kind, seed, index);
  const simulation::Capture capture =
      simulation::capture(view.scene, simulation::recipeNoiseSeed(seed, index));
  const geometry::Pose truth = trueBaseFromCamera(view.scene);
  record.dictionary = view.options.marker.dictionary;
  record.tilt_rad = std::acos(std::min(1.0, -truth.linear()(2, 2)));
  record.distance_m = truth.translation().norm();
  const auto start = std::chrono::steady_clock::now();
  const detection::BaseFrameResult result =
      detection::findBaseFrame(capture.cloud.view(), detection::BaseFrameSource::kMarker, view.options);
  record.milliseconds =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  record.message = result.message;
  record.found = result.frame.has_value();
  if (!record.found) return record;
  record.errors = baseFrameErrors(truth, result.frame->base_from_camera);
  record.rotation_rad = std::abs(
      Eigen::AngleAxisd(result.frame->base_from_camera.linear() * truth.linear().transpose()).angle());
  return record;
}

BaseFrameSummary summarize(const std::vector<BaseFrameRecord>& records, MarkerKind kind) {
  BaseFrameSummary summary;
  std::vector<double> position, rotation, yaw, milliseconds;
  for (const BaseFrameRecord& record : records) {
    if (record.kind != kind) continue;
    ++summary.views;
    milliseconds.push_back(record.milliseconds);
    if (!record.found) continue;
    ++summary.found;
    position.push_back(kMillimetres * record.position_m());
    rotation.push_back(kDegrees * record.rotation_rad);
    yaw.push_back(kDegrees * record.errors.yaw_rad);
  }
  summary.position_mm = statisticsOf(position);
  summary.rotation_deg = statisticsOf(rotation);
  summary.yaw_deg = statisticsOf(yaw);
  summary.milliseconds = statisticsOf(milliseconds);
  return summary;
}

std::string summaryText(const std::string& name, const BaseFrameSummary& s) {
  char text[400];
  std::snprintf(text, sizeof text,
                "%-9s found %zu of %zu  position mm mean %.4f rms %.4f p95 %.4f worst %.4f  "
                "rotation deg mean %.5f rms %.5f p95 %.5f worst %.5f  median ms %.0f",
                name.c_str(), s.found, s.views, s.position_mm.mean, s.position_mm.rms, s.position_mm.p95,
                s.position_mm.worst, s.rotation_deg.mean, s.rotation_deg.rms, s.rotation_deg.p95,
                s.rotation_deg.worst, s.milliseconds.median);
  return text;
}

std::string recordJson(const BaseFrameRecord& record) {
  nlohmann::json out{{"view", record.index},
                     {"kind", toString(record.kind)},
                     {"dictionary", record.dictionary},
                     {"tilt_deg", kDegrees * record.tilt_rad},
                     {"distance_m", record.distance_m},
                     {"found", record.found},
                     {"message", record.message},
                     {"ms", record.milliseconds}};
  if (record.found) {
    out["position_mm"] = kMillimetres * record.position_m();
    out["rotation_deg"] = kDegrees * record.rotation_rad;
    out["yaw_deg"] = kDegrees * record.errors.yaw_rad;
  }
  return out.dump();
}

}  // namespace mixed_palletizing::experiments
