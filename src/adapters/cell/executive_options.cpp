#include <cmath>

#include <mixed_palletizing/adapters/cell/executive_options.hpp>
#include <mixed_palletizing/adapters/option_reader.hpp>
#include <mixed_palletizing/adapters/parameters.hpp>

namespace mixed_palletizing::cell {
namespace {

constexpr int kMostCalibrationClouds = 1000;

}  // namespace

std::vector<std::string> problems(const CellExecutiveOptions& options) {
  std::vector<std::string> all = problems(options.order);
  for (const std::string& problem : problems(options.dialogue)) all.push_back(problem);
  const CellLinkOptions& link = options.link;
  for (const auto& [key, name] : {std::pair<const char*, const std::string&>("camera", link.camera),
                                  {"detector", link.detector},
                                  {"planner", link.planner}}) {
    if (name.empty()) all.push_back(std::string(key) + ": a name is needed");
  }
  for (const auto& [key, seconds] : {std::pair<const char*, double>("cloud_timeout_s", link.cloud_timeout_s),
                                     {"calibration_timeout_s", link.calibration_timeout_s},
                                     {"call_timeout_s", link.call_timeout_s}}) {
    if (!(seconds > 0.0)) {
      all.push_back(std::string(key) + ": " + std::to_string(seconds) + " s is not positive");
    }
  }
  for (const auto& [key, seconds] : {std::pair<const char*, double>("service_wait_s", link.service_wait_s),
                                     {"move_s", link.move_s},
                                     {"hold_s", options.hold_s}}) {
    if (!(seconds >= 0.0))
      all.push_back(std::string(key) + ": " + std::to_string(seconds) + " s is negative");
  }
  if (link.calibration_clouds < 0 || link.calibration_clouds > kMostCalibrationClouds) {
    all.push_back("calibration_clouds: " + std::to_string(link.calibration_clouds) + " is not in [0, " +
                  std::to_string(kMostCalibrationClouds) + "]");
  }
  return all;
}

CellExecutiveOptions readCellExecutiveOptions(const YAML::Node& tree) {
  CellExecutiveOptions options;
  adapters::OptionReader reader(tree);
  readCellOrderOptions(reader, options.order);
  reader.read("pallet_id", options.dialogue.pallet_id);
  reader.read("close_open", options.dialogue.close_open);
  reader.read("time_budget_s", options.dialogue.time_budget_s);
  reader.read("retries", options.dialogue.retries);
  reader.read("camera", options.link.camera);
  reader.read("detector", options.link.detector);
  reader.read("planner", options.link.planner);
  reader.read("triggers_camera", options.link.triggers_camera);
  reader.read("calibration_clouds", options.link.calibration_clouds);
  reader.read("cloud_timeout_s", options.link.cloud_timeout_s);
  reader.read("calibration_timeout_s", options.link.calibration_timeout_s);
  reader.read("call_timeout_s", options.link.call_timeout_s);
  reader.read("service_wait_s", options.link.service_wait_s);
  reader.read("move_s", options.link.move_s);
  reader.read("report", options.report);
  reader.read("hold_s", options.hold_s);
  reader.add(problems(options));
  reader.finish("parameters of the cell's executive");
  options.report = adapters::expandPath(options.report);
  return options;
}

}  // namespace mixed_palletizing::cell
