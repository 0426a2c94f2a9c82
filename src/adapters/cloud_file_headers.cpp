#include "cloud_file_headers.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

namespace mixed_palletizing::adapters {
namespace {

/// LZF shrinks at most 264 bytes to 3; ascii and binary files shrink less.
constexpr double kMaxCompression = 100.0;

std::vector<double> numbers(const std::string& text) {
  std::vector<double> values;
  std::istringstream words(text);
  for (double value = 0.0; words >> value;) values.push_back(value);
  return values;
}

/// Bytes of all points as the header promises them.
double promisedBytes(std::map<std::string, std::string>& header) {
  const std::vector<double> sizes = numbers(header["SIZE"]);
  const std::vector<double> counts = numbers(header["COUNT"]);
  double step = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i) step += sizes[i] * (i < counts.size() ? counts[i] : 1.0);
  const std::vector<double> points = numbers(header["POINTS"]);
  return points.empty() ? 0.0 : step * points[0];
}

std::string tooLong(double promised, std::size_t file_bytes) {
  std::ostringstream text;
  text << "damaged: its header promises " << promised << " bytes of points, the file has " << file_bytes;
  return text.str();
}

}  // namespace

std::string pcdHeaderProblem(std::istream& file, std::size_t file_bytes) {
  static const std::set<std::string> known = {"VERSION", "FIELDS", "SIZE",      "TYPE",   "COUNT",
                                              "WIDTH",   "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
  std::map<std::string, std::string> header;
  std::string line;
  for (int number = 1; header.count("DATA") == 0 && std::getline(file, line); ++number) {
    std::istringstream words(line);
    std::string key;
    if (!(words >> key) || key[0] == '#') continue;
    std::string rest;
    std::getline(words >> std::ws, rest);
    if (known.count(key) == 0 || rest.empty() || !header.emplace(key, rest).second) {
      return "not a PCD file: line " + std::to_string(number) + " of its header is damaged";
    }
  }
  for (const char* key : {"FIELDS", "SIZE", "TYPE", "WIDTH", "HEIGHT", "POINTS", "DATA"}) {
    if (header.count(key) == 0) return std::string("not a PCD file: no ") + key + " in its header";
  }
  const double promised = promisedBytes(header);
  if (promised > kMaxCompression * static_cast<double>(file_bytes)) return tooLong(promised, file_bytes);
  return {};
}

std::string plyHeaderProblem(std::istream& file, std::size_t file_bytes) {
  std::string line;
  std::getline(file, line);
  if (line.compare(0, 3, "ply") != 0) return "not a PLY file";
  double grid = 1.0;
  while (std::getline(file, line) && line.compare(0, 10, "end_header") != 0) {
    const bool is_element = line.compare(0, 8, "element ") == 0;
    const bool is_grid =
        line.find("num_cols") != std::string::npos || line.find("num_rows") != std::string::npos;
    if (!is_element && !is_grid) continue;
    for (const double count : numbers(line.substr(line.find_last_of(' ') + 1))) {
      if (is_grid) grid *= std::max(count, 1.0);
      const double least_bytes =
          is_grid ? grid : count;  // an entry takes a byte at least, and so does a cell
      if (least_bytes > static_cast<double>(file_bytes)) return tooLong(least_bytes, file_bytes);
    }
  }
  if (!file) return "not a PLY file: its header has no end";
  return {};
}

}  // namespace mixed_palletizing::adapters
