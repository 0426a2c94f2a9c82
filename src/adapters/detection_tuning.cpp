#include <exception>
#include <string>
#include <utility>

#include <dynamic_reconfigure/server.h>
#include <ros/console.h>

#include <mixed_palletizing/adapters/detection_tuning.hpp>

namespace mixed_palletizing::adapters {
namespace {

/// Calls visit(value of the config, value of the options) for every value that can be turned.
template <typename Config, typename Options, typename Visit>
void forEachValue(Config& config, Options& options, Visit visit) {
  visit(config.noise_sigmas, options.noise.sigmas);
  visit(config.noise_spacings, options.noise.spacings);
  visit(config.cluster_min_height_m, options.cluster.min_height_m);
  visit(config.cluster_max_height_m, options.cluster.max_height_m);
  visit(config.cluster_neighbor_distance_m, options.cluster.neighbor_distance_m);
  visit(config.cluster_min_points, options.cluster.min_points);
  visit(config.top_uneven_m, options.top.uneven_m);
  visit(config.box_min_side_m, options.box.min_side_m);
  visit(config.box_max_side_m, options.box.max_side_m);
  visit(config.box_min_rectangularity, options.box.min_rectangularity);
  visit(config.box_min_outline_ratio, options.box.min_outline_ratio);
  visit(config.box_touching_distance_m, options.box.touching_distance_m);
  visit(config.stack_max_slope_rad, options.stack.max_slope_rad);
  visit(config.stack_step_m, options.stack.step_m);
  visit(config.stack_min_height_m, options.stack.min_height_m);
  visit(config.region_min_z_m, options.region.min_z_m);
  visit(config.region_max_z_m, options.region.max_z_m);
}

}  // namespace

DetectionConfig toConfig(const detection::DetectionOptions& options) {
  DetectionConfig config = DetectionConfig::__getDefault__();
  forEachValue(config, options, [](auto& to, const auto& from) { to = from; });
  config.method =
      options.method == detection::Method::kThesis ? Detection_method_thesis : Detection_method_best;
  config.mode =
      options.mode == detection::Mode::kDepalletize ? Detection_mode_depalletize : Detection_mode_palletize;
  return config;
}

detection::DetectionOptions withConfig(detection::DetectionOptions options, const DetectionConfig& config) {
  forEachValue(config, options, [](const auto& from, auto& to) { to = from; });
  options.method =
      config.method == Detection_method_thesis ? detection::Method::kThesis : detection::Method::kBest;
  options.mode =
      config.mode == Detection_mode_depalletize ? detection::Mode::kDepalletize : detection::Mode::kPalletize;
  return options;
}

class DetectionTuning::Impl {
 public:
  Impl(const ros::NodeHandle& node, const detection::DetectionOptions& options, Apply apply)
      : options_(options), apply_(std::move(apply)), server_(mutex_, node) {
    server_.updateConfig(toConfig(options_));
    server_.setCallback([this](DetectionConfig& config, std::uint32_t) { change(config); });
  }

 private:
  /// Called with the server's mutex locked; what is left in `config` becomes the values that everybody sees.
  void change(DetectionConfig& config) {
    const detection::DetectionOptions wanted = withConfig(options_, config);
    std::string wrong;
    for (const std::string& line : detection::problems(wanted)) wrong += (wrong.empty() ? "" : "; ") + line;
    try {
      if (wrong.empty()) apply_(wanted);
    } catch (const std::exception& error) {
      wrong = error.what();
    }
    if (wrong.empty()) {
      options_ = wanted;
      config.answer = "in use";
      return;
    }
    ROS_WARN_STREAM("change of the detection refused: " << wrong);
    config = toConfig(options_);
    config.answer = "refused: " + wrong;
  }

  detection::DetectionOptions options_;
  Apply apply_;
  boost::recursive_mutex mutex_;
  dynamic_reconfigure::Server<DetectionConfig> server_;
};

DetectionTuning::DetectionTuning(const ros::NodeHandle& node, const detection::DetectionOptions& options,
                                 Apply apply)
    : impl_(std::make_unique<Impl>(node, options, std::move(apply))) {}

DetectionTuning::~DetectionTuning() = default;

}  // namespace mixed_palletizing::adapters
