#include "marker_picture.hpp"

#include <cmath>
#include <map>
#include <stdexcept>

#include <opencv2/aruco.hpp>

namespace mixed_palletizing::simulation {
namespace {

const std::map<std::string, int>& dictionaryCodes() {
  static const std::map<std::string, int> codes = {
      {"DICT_4X4_50", cv::aruco::DICT_4X4_50},
      {"DICT_4X4_100", cv::aruco::DICT_4X4_100},
      {"DICT_4X4_250", cv::aruco::DICT_4X4_250},
      {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
      {"DICT_5X5_50", cv::aruco::DICT_5X5_50},
      {"DICT_5X5_100", cv::aruco::DICT_5X5_100},
      {"DICT_5X5_250", cv::aruco::DICT_5X5_250},
      {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
      {"DICT_6X6_50", cv::aruco::DICT_6X6_50},
      {"DICT_6X6_100", cv::aruco::DICT_6X6_100},
      {"DICT_6X6_250", cv::aruco::DICT_6X6_250},
      {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
      {"DICT_7X7_50", cv::aruco::DICT_7X7_50},
      {"DICT_7X7_100", cv::aruco::DICT_7X7_100},
      {"DICT_7X7_250", cv::aruco::DICT_7X7_250},
      {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
      {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
      {"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5},
      {"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9},
      {"DICT_APRILTAG_36h10", cv::aruco::DICT_APRILTAG_36h10},
      {"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11},
  };
  return codes;
}

cv::Ptr<cv::aruco::Dictionary> dictionaryOf(const std::string& name) {
  const auto code = dictionaryCodes().find(name);
  if (code == dictionaryCodes().end()) return nullptr;
  return cv::aruco::getPredefinedDictionary(code->second);
}

}  // namespace

int markerCount(const std::string& dictionary) {
  const cv::Ptr<cv::aruco::Dictionary> found = dictionaryOf(dictionary);
  return found ? found->bytesList.rows : 0;
}

MarkerPicture::MarkerPicture(const Marker& marker)
    : side_m_(marker.side_m), quiet_zone_m_(marker.quiet_zone_m), quiet_zone_white_(!marker.inverted) {
  const cv::Ptr<cv::aruco::Dictionary> dictionary = dictionaryOf(marker.dictionary);
  if (!dictionary || marker.id < 0 || marker.id >= dictionary->bytesList.rows) {
    throw std::invalid_argument("MarkerPicture: no marker " + std::to_string(marker.id) + " in dictionary '" +
                                marker.dictionary + "'");
  }
  cells_ = dictionary->markerSize + 2;
  cv::Mat picture;  // one pixel a cell
  cv::aruco::drawMarker(dictionary, marker.id, cells_, picture, 1);
  for (int row = 0; row < cells_; ++row) {
    for (int col = 0; col < cells_; ++col) {
      white_.push_back((picture.at<std::uint8_t>(row, col) > 127) != marker.inverted ? 1 : 0);
    }
  }
}

std::optional<bool> MarkerPicture::isWhite(double x, double y) const {
  const double half_paper = 0.5 * paperSide();
  if (std::abs(x) > half_paper || std::abs(y) > half_paper) return std::nullopt;
  // The picture's rows run against the marker's y axis.
  const int col = static_cast<int>(std::floor((x / side_m_ + 0.5) * cells_));
  const int row = static_cast<int>(std::floor((0.5 - y / side_m_) * cells_));
  if (col < 0 || row < 0 || col >= cells_ || row >= cells_) return quiet_zone_white_;
  return white_[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_) +
                static_cast<std::size_t>(col)] != 0;
}

}  // namespace mixed_palletizing::simulation
