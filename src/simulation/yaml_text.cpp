#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <yaml-cpp/eventhandler.h>

#include <mixed_palletizing/simulation/yaml_text.hpp>

namespace mixed_palletizing::simulation {
namespace {

/// Counts what the parser finds, which asks before it goes a level deeper.
class Limits : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { count(mark); }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { count(mark); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string&) override {
    count(mark);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    enter(mark);
  }
  void OnSequenceEnd() override { --depth_; }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    enter(mark);
  }
  void OnMapEnd() override { --depth_; }

 private:
  void count(const YAML::Mark& mark) {
    if (++values_ > kMaxYamlValues) {
      throw YAML::ParserException(mark, "more than " + std::to_string(kMaxYamlValues) + " values");
    }
  }
  void enter(const YAML::Mark& mark) {
    count(mark);
    if (++depth_ > kMaxYamlDepth) {
      throw YAML::ParserException(mark, "lists and maps within each other over more than " +
                                            std::to_string(kMaxYamlDepth) + " levels");
    }
  }

  int values_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string readYamlText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 1U << 16U> part{};
  while (file && text.size() <= kMaxYamlBytes) {
    file.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.is_open() || file.bad()) {
    throw std::runtime_error(path + ": cannot be read: " + std::strerror(errno));
  }
  if (text.size() > kMaxYamlBytes) {
    throw std::runtime_error(path + ": cannot be read: it has more than " + std::to_string(kMaxYamlBytes) +
                             " bytes");
  }
  return text;
}

YAML::Node parseYamlText(const std::string& text) {
  std::istringstream in(text);
  Limits limits;
  YAML::Parser(in).HandleNextDocument(limits);
  return YAML::Load(text);
}

}  // namespace mixed_palletizing::simulation
