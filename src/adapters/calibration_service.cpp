#include "calibration_service.hpp"

#include <cmath>
#include <cstring>

#include <cv_bridge/cv_bridge.h>
#include <opencv2/imgproc.hpp>
#include <sensor_msgs/image_encodings.h>

#include <mixed_palletizing/adapters/message_parts.hpp>

namespace mixed_palletizing::adapters {
namespace {

constexpr double kLongestTimeoutS = 3600.0;
constexpr std::uint32_t kMostClouds = 1000;

detection::BaseFrameSource sourceOf(BaseSource source) {
  return source == BaseSource::kMarker ? detection::BaseFrameSource::kMarker
                                       : detection::BaseFrameSource::kFloor;
}

cv::Mat picture(const geometry::CloudView& view) {
  cv::Mat image(view.height, view.width, CV_8UC3, cv::Scalar::all(0));
  if (!view.hasColor()) return image;
  for (int row = 0; row < view.height; ++row) {
    for (int col = 0; col < view.width; ++col) {
      std::memcpy(image.ptr(row, col), view.bgr(row, col), 3);
    }
  }
  return image;
}

}  // namespace

CalibrationRun::CalibrationRun(const DetectorOptions& options, const CalibrateRequest& request)
    : options_(options),
      wanted_(request.cloud_count > 0 ? request.cloud_count
                                      : static_cast<std::size_t>(options.calibration_clouds)) {
  const bool given = options_.base_source == BaseSource::kFile || options_.base_source == BaseSource::kTf;
  if (given) {
    fail(CalibrateResponse::NOT_APPLICABLE, "the base frame is given: base_source is file or tf");
  } else if (request.cloud_count > kMostClouds) {
    fail(CalibrateResponse::BAD_REQUEST, "cloud_count: " + std::to_string(request.cloud_count) +
                                             " is more than " + std::to_string(kMostClouds));
  } else if (!(request.timeout >= 0.0 && request.timeout <= kLongestTimeoutS)) {
    fail(CalibrateResponse::BAD_REQUEST,
         "timeout: " + std::to_string(request.timeout) + " s is not within 0 and 3600");
  }
}

void CalibrationRun::fail(std::uint8_t status, const std::string& message) {
  failed_ = true;
  response_.status = status;
  response_.message = message;
}

void CalibrationRun::add(const Arrival& arrival) {
  const std::string cloud =
      "cloud " + std::to_string(frames_.size() + 1) + " of " + std::to_string(wanted_) + ": ";
  if (arrival.kind == Arrival::Kind::kDropped)
    return fail(CalibrateResponse::BAD_CLOUD, cloud + arrival.dropped);
  if (arrival.kind != Arrival::Kind::kCloud)
    return fail(CalibrateResponse::TIMEOUT,
                cloud + "none came in time" + (arrival.dropped.empty() ? "" : ": " + arrival.dropped));
  const std::string& frame_id = arrival.cloud.message->header.frame_id;
  if (!camera_frame_.empty() && frame_id != camera_frame_) {
    return fail(CalibrateResponse::BAD_CLOUD,
                cloud + "comes from frame '" + frame_id + "', the one before from '" + camera_frame_ + "'");
  }
  camera_frame_ = frame_id;
  const detection::BaseFrameResult result =
      detection::findBaseFrame(arrival.cloud.view, sourceOf(options_.base_source), options_.detection);
  if (!result.frame) return fail(CalibrateResponse::NO_FRAME, cloud + result.message);
  frames_.push_back(*result.frame);
}

sensor_msgs::ImagePtr CalibrationRun::markerImage(const AcceptedCloud& cloud) const {
  cv::Mat image = picture(cloud.view);
  if (!failed_ && !frames_.empty()) {
    for (const detection::MarkerSighting& marker : frames_.back().markers) {
      const auto at = [&](std::size_t i) {
        return cv::Point(cvRound(marker.corners_px[i].x()), cvRound(marker.corners_px[i].y()));
      };
      for (std::size_t i = 0; i < 4; ++i) {
        // Corner 0 to 1 is the base frame's x: drawn red, as x axes are.
        const cv::Scalar tone = i == 0 ? cv::Scalar(0, 0, 255) : cv::Scalar(0, 255, 0);
        cv::line(image, at(i), at((i + 1) % 4), tone, 2, cv::LINE_AA);
      }
      cv::putText(image, "id " + std::to_string(marker.id), at(0), cv::FONT_HERSHEY_SIMPLEX, 0.8,
                  cv::Scalar(0, 255, 255), 2, cv::LINE_AA);
    }
  }
  return cv_bridge::CvImage(cloud.message->header, sensor_msgs::image_encodings::BGR8, image).toImageMsg();
}

void CalibrationRun::finish(BaseFrameKeeper& keeper) {
  if (failed_) return;
  const detection::AveragedBaseFrame mean = detection::averageBaseFrames(frames_);
  keeper.set(camera_frame_, mean.frame.base_from_camera,
             detection::removedPlanes(mean.frame, options_.detection.plane.remove));
  response_.status = CalibrateResponse::OK;
  response_.pose.header.frame_id = options_.base_frame;
  response_.pose.header.stamp = ros::Time::now();
  response_.pose.pose = poseMessage(mean.frame.base_from_camera);
  response_.camera_frame = camera_frame_;
  for (const detection::MarkerSighting& marker : mean.frame.markers) {
    response_.marker_ids.push_back(marker.id);
    for (const Eigen::Vector3d& corner : marker.corners)
      response_.marker_corners.push_back(pointMessage(corner));
  }
  for (const detection::FoundPlane& plane : mean.frame.planes) {
    response_.planes.push_back(poseMessage(plane.base_from_plane));
  }
  response_.board_rms = mean.frame.board_rms_m;
  response_.plane_inliers = mean.frame.plane_inliers;
  response_.plane_rms = mean.frame.plane_rms_m;
  response_.spread_position = mean.spread_m;
  response_.spread_angle = mean.spread_rad;
  response_.clouds_used = static_cast<std::uint32_t>(frames_.size());
  response_.message = keeper.description();
}

}  // namespace mixed_palletizing::adapters
