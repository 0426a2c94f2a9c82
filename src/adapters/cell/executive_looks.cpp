#include <chrono>

#include <mixed_palletizing/adapters/cell/executive_looks.hpp>

namespace mixed_palletizing::cell {
namespace {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

CellLook CellLooks::look() {
  std::string failure;
  for (int i = 0; i <= retries_; ++i) {
    if (i > 0) link_.warn(failure + "; looking again");
    failure.clear();
    CellLook seen = lookOnce(failure);
    if (failure.empty()) return seen;
  }
  throw CellError("detect: no usable cloud in " + std::to_string(retries_ + 1) + " looks: " + failure);
}

/// `failure` is set when another look may help.
CellLook CellLooks::lookOnce(std::string& failure) {
  CellLook seen;
  const auto start = std::chrono::steady_clock::now();
  link_.capture();
  seen.capture_ms = millisecondsSince(start);
  const DetectBoxesResponse response = link_.detect();
  switch (response.status) {
    case DetectBoxesResponse::OK:
      break;
    case DetectBoxesResponse::NOT_CALIBRATED:
      calibrate();
      return lookOnce(failure);
    case DetectBoxesResponse::TIMEOUT:
    case DetectBoxesResponse::BAD_CLOUD:
      failure = response.message;
      return seen;
    default:
      throw CellError("detect: " + response.message);
  }
  seen.seen = response.boxes;
  seen.detection_ms = response.boxes.processing_ms;
  return seen;
}

void CellLooks::calibrate() {
  if (calibrated_) throw CellError("the detector has lost its base frame after a calibration that succeeded");
  const CalibrateResponse response = link_.calibrate();
  if (!response.success) throw CellError("calibrate: " + response.message);
  calibrated_ = true;
  link_.say("calibration: " + response.message);
}

}  // namespace mixed_palletizing::cell
