#include "text_lines.hpp"

#include <fstream>
#include <limits>
#include <stdexcept>

namespace mixed_palletizing::instances {
namespace {

/// The next line without its end, cut at kMaxLineBytes + 1 so that a file without line ends fills no memory, nor is
/// read for ever.
bool nextLine(std::istream& in, std::string& line) {
  line.clear();
  std::streambuf& buffer = *in.rdbuf();
  int c = buffer.sbumpc();
  if (c == std::char_traits<char>::eof()) return false;
  for (; c != std::char_traits<char>::eof() && c != '\n'; c = buffer.sbumpc()) {
    line.push_back(static_cast<char>(c));
    if (line.size() > kMaxLineBytes) return true;
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return true;
}

}  // namespace

void forEachLine(const std::string& path, std::vector<std::string>& faults,
                 const std::function<void(const std::string& line, int number,
                                          std::vector<std::string>& line_faults)>& read) {
  std::ifstream in(path, std::ios::binary);
  if (!in || in.peek() == std::char_traits<char>::eof()) {
    throw std::runtime_error(path + ": cannot be read or is empty");
  }
  std::string line;
  for (int number = 1; in && nextLine(in, line); ++number) {
    std::vector<std::string> line_faults;
    if (line.size() > kMaxLineBytes) {
      line_faults.push_back("longer than " + std::to_string(kMaxLineBytes) + " bytes: nothing more is read");
      in.setstate(std::ios::failbit);
    } else if (line.find_first_not_of(" \t") != std::string::npos) {
      try {
        read(line, number, line_faults);
      } catch (const std::invalid_argument& error) {
        line_faults.emplace_back(error.what());
      }
    }
    for (const std::string& fault : line_faults) {
      faults.push_back(path + ":" + std::to_string(number) + ": " + fault);
    }
  }
}

std::string stemOf(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = name.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? name : name.substr(0, dot);
}

}  // namespace mixed_palletizing::instances
