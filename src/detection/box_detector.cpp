#include <stdexcept>
#include <string>
#include <vector>

#include <mixed_palletizing/detection/box_detector.hpp>

#include "detection_pipeline.hpp"
#include "stack_pipeline.hpp"

namespace mixed_palletizing::detection {
namespace {

void requireUsable(const geometry::CloudView& cloud, const geometry::Pose& base_from_camera) {
  if (cloud.data == nullptr || cloud.width <= 0 || cloud.height <= 0) {
    throw std::invalid_argument("BoxDetector::detect: cloud: no data or no size (" +
                                std::to_string(cloud.width) + " x " + std::to_string(cloud.height) +
                                " points)");
  }
  const Eigen::Matrix3d r = base_from_camera.linear();
  const bool rotation =
      (r * r.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-3 && r.determinant() > 0.0;
  if (!rotation || !base_from_camera.translation().allFinite()) {
    throw std::invalid_argument(
        "BoxDetector::detect: base_from_camera: not a rotation and a finite translation");
  }
}

}  // namespace

class BoxDetector::Impl {
 public:
  explicit Impl(const DetectionOptions& options)
      : options_(options),
        pipeline_(options.method == Method::kThesis ? makeThesisPipeline(options_)
                                                    : makeLevelPipeline(options_)),
        stack_(options_) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Detections detect(const geometry::CloudView& cloud, const geometry::Pose& base_from_camera,
                    bool keep_stages) {
    if (options_.mode == Mode::kDepalletize) return stack_.detect(cloud, base_from_camera, keep_stages);
    return pipeline_->detect(cloud, base_from_camera, keep_stages);
  }
  const DetectionOptions& options() const { return options_; }

 private:
  const DetectionOptions options_;
  std::unique_ptr<DetectionPipeline> pipeline_;
  StackPipeline stack_;
};

BoxDetector::BoxDetector(const DetectionOptions& options) {
  const std::vector<std::string> wrong = problems(options);
  if (!wrong.empty()) {
    std::string message = "BoxDetector: options:";
    for (const std::string& line : wrong) message += "\n  " + line;
    throw std::invalid_argument(message);
  }
  impl_ = std::make_unique<Impl>(options);
}

BoxDetector::~BoxDetector() = default;
BoxDetector::BoxDetector(BoxDetector&&) noexcept = default;
BoxDetector& BoxDetector::operator=(BoxDetector&&) noexcept = default;

Detections BoxDetector::detect(const geometry::CloudView& cloud, const geometry::Pose& base_from_camera,
                               bool keep_stages) {
  requireUsable(cloud, base_from_camera);
  return impl_->detect(cloud, base_from_camera, keep_stages);
}

const DetectionOptions& BoxDetector::options() const { return impl_->options(); }

}  // namespace mixed_palletizing::detection
