#include "marker_dictionary.hpp"

#include <array>
#include <stdexcept>

#include <opencv2/aruco.hpp>

namespace mixed_palletizing::detection {
namespace {

struct Dictionary {
  const char* name;
  int number;
  int size;
};

constexpr std::array<Dictionary, 21> kDictionaries{{
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50, 50},
    {"DICT_4X4_100", cv::aruco::DICT_4X4_100, 100},
    {"DICT_4X4_250", cv::aruco::DICT_4X4_250, 250},
    {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000, 1000},
    {"DICT_5X5_50", cv::aruco::DICT_5X5_50, 50},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100, 100},
    {"DICT_5X5_250", cv::aruco::DICT_5X5_250, 250},
    {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000, 1000},
    {"DICT_6X6_50", cv::aruco::DICT_6X6_50, 50},
    {"DICT_6X6_100", cv::aruco::DICT_6X6_100, 100},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250, 250},
    {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000, 1000},
    {"DICT_7X7_50", cv::aruco::DICT_7X7_50, 50},
    {"DICT_7X7_100", cv::aruco::DICT_7X7_100, 100},
    {"DICT_7X7_250", cv::aruco::DICT_7X7_250, 250},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000, 1000},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL, 1024},
    {"DICT_APRILTAG_16h5", cv::aruco::DICT_APRILTAG_16h5, 30},
    {"DICT_APRILTAG_25h9", cv::aruco::DICT_APRILTAG_25h9, 35},
    {"DICT_APRILTAG_36h10", cv::aruco::DICT_APRILTAG_36h10, 2320},
    {"DICT_APRILTAG_36h11", cv::aruco::DICT_APRILTAG_36h11, 587},
}};

const Dictionary* find(const std::string& name) {
  for (const Dictionary& dictionary : kDictionaries) {
    if (name == dictionary.name) return &dictionary;
  }
  return nullptr;
}

}  // namespace

std::optional<int> dictionarySize(const std::string& name) {
  const Dictionary* dictionary = find(name);
  if (dictionary == nullptr) return std::nullopt;
  return dictionary->size;
}

std::optional<int> dictionaryNumber(const std::string& name) {
  const Dictionary* dictionary = find(name);
  if (dictionary == nullptr) return std::nullopt;
  return dictionary->number;
}

std::vector<bool> markerCells(const std::string& dictionary, int id) {
  const Dictionary* known = find(dictionary);
  if (known == nullptr || id < 0 || id >= known->size) {
    throw std::invalid_argument("markerCells: no marker " + std::to_string(id) + " in dictionary '" +
                                dictionary + "'");
  }
  const auto markers = cv::aruco::getPredefinedDictionary(known->number);
  const int cells = markers->markerSize + 2;
  cv::Mat picture;  // one pixel a cell
  cv::aruco::drawMarker(markers, id, cells, picture, 1);
  std::vector<bool> white;
  for (int row = 0; row < cells; ++row) {
    for (int col = 0; col < cells; ++col) white.push_back(picture.at<std::uint8_t>(row, col) > 127);
  }
  return white;
}

}  // namespace mixed_palletizing::detection
