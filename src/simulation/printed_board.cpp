#include "printed_board.hpp"

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

PrintedBoard::PrintedBoard(const MarkerBoard& board)
    : columns_(board.columns),
      rows_(board.rows),
      side_m_(board.first.side_m),
      pitch_m_(board.first.side_m + board.gap_m),
      paper_white_(!board.first.inverted),
      markers_size_m_(pitch_m_ * columns_ - board.gap_m, pitch_m_ * rows_ - board.gap_m),
      paper_size_m_(markers_size_m_.array() + 2.0 * board.first.quiet_zone_m) {
  const Marker& first = board.first;
  const cv::Ptr<cv::aruco::Dictionary> dictionary = dictionaryOf(first.dictionary);
  if (!dictionary || first.id < 0 || first.id + columns_ * rows_ > dictionary->bytesList.rows) {
    throw std::invalid_argument("PrintedBoard: no " + std::to_string(columns_ * rows_) + " markers from id " +
                                std::to_string(first.id) + " in dictionary '" + first.dictionary + "'");
  }
  cells_ = dictionary->markerSize + 2;
  for (int i = 0; i < columns_ * rows_; ++i) {
    cv::Mat picture;  // one pixel a cell
    cv::aruco::drawMarker(dictionary, first.id + i, cells_, picture, 1);
    std::vector<std::uint8_t>& white = white_.emplace_back();
    for (int row = 0; row < cells_; ++row) {
      for (int col = 0; col < cells_; ++col) {
        white.push_back((picture.at<std::uint8_t>(row, col) > 127) != first.inverted ? 1 : 0);
      }
    }
  }
}

std::optional<bool> PrintedBoard::isWhite(double x, double y) const {
  if (std::abs(x) > 0.5 * paper_size_m_.x() || std::abs(y) > 0.5 * paper_size_m_.y()) return std::nullopt;
  // From the picture's top left; its rows run against the board's y axis.
  const double right = x + 0.5 * markers_size_m_.x();
  const double down = 0.5 * markers_size_m_.y() - y;
  const int marker_col = static_cast<int>(std::floor(right / pitch_m_));
  const int marker_row = static_cast<int>(std::floor(down / pitch_m_));
  if (marker_col < 0 || marker_row < 0 || marker_col >= columns_ || marker_row >= rows_) return paper_white_;
  const int col = static_cast<int>(std::floor((right - marker_col * pitch_m_) / side_m_ * cells_));
  const int row = static_cast<int>(std::floor((down - marker_row * pitch_m_) / side_m_ * cells_));
  if (col >= cells_ || row >= cells_) return paper_white_;
  const auto marker = static_cast<std::size_t>(marker_row) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(marker_col);
  return white_[marker][static_cast<std::size_t>(row) * static_cast<std::size_t>(cells_) +
                        static_cast<std::size_t>(col)] != 0;
}

}  // namespace mixed_palletizing::simulation
