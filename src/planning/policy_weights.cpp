#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include <mixed_palletizing/planning/placement_policy.hpp>

#include "tuned_policy.hpp"

namespace mixed_palletizing::planning {
namespace {

constexpr int kDigits = 6;  ///< of a weight in a file

std::size_t featureFromString(const std::string& word) {
  std::size_t i = 0;
  while (i < kPolicyFeatureCount && word != toString(static_cast<PolicyFeature>(i))) ++i;
  return i;
}

class Reader {
 public:
  explicit Reader(std::string path) : path_(std::move(path)) {}

  PolicyWeights read(std::istream& file) {
    for (std::string line; std::getline(file, line);) {
      ++line_;
      std::istringstream words(line.substr(0, line.find('#')));
      std::string name;
      if (words >> name) take(name, words);
    }
    for (std::size_t i = 0; i < kPolicyFeatureCount; ++i) {
      if (!given_[i]) fail(std::string("'") + toString(static_cast<PolicyFeature>(i)) + "' is missing");
    }
    return weights_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::invalid_argument(path_ + ":" + std::to_string(line_) + ": " + what);
  }

  void take(const std::string& name, std::istream& words) {
    const std::size_t feature = featureFromString(name);
    if (feature == kPolicyFeatureCount) fail("'" + name + "' is no feature of the policy");
    if (given_[feature]) fail("'" + name + "' is given twice");
    std::string rest;
    if (!(words >> weights_[feature]) || !std::isfinite(weights_[feature]) || words >> rest) {
      fail("'" + name + "' needs one finite number");
    }
    given_[feature] = true;
  }

  std::string path_;
  int line_ = 0;
  PolicyWeights weights_{};
  std::array<bool, kPolicyFeatureCount> given_{};
};

}  // namespace

const char* toString(PolicyFeature feature) {
  static constexpr std::array<const char*, kPolicyFeatureCount> kNames{"unfit_ratio",
                                                                       "unfit_ratio_cubed",
                                                                       "scarcity",
                                                                       "scarcity_by_volume",
                                                                       "shortage",
                                                                       "spaces",
                                                                       "levels",
                                                                       "base_height",
                                                                       "top_above_lowest",
                                                                       "box_volume",
                                                                       "box_footprint",
                                                                       "beyond_places",
                                                                       "largest_base",
                                                                       "largest_scarcity",
                                                                       "unfit_ratio_by_volume",
                                                                       "dead_room",
                                                                       "merged_top",
                                                                       "fill_rate"};
  return kNames.at(feature);
}

const PolicyWeights& tunedPolicyWeights() {
  static const PolicyWeights weights = [] {
    std::istringstream text(kTunedPolicy);
    return Reader("config/placement_policy.txt").read(text);
  }();
  return weights;
}

PolicyWeights readPolicyWeights(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  return Reader(path).read(file);
}

std::string formatPolicyWeights(const PolicyWeights& weights, const std::vector<std::string>& comment) {
  std::ostringstream text;
  for (const std::string& line : comment) text << "# " << line << '\n';
  text << std::setprecision(kDigits);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    text << toString(static_cast<PolicyFeature>(i)) << ' ' << weights[i] << '\n';
  }
  return text.str();
}

}  // namespace mixed_palletizing::planning
