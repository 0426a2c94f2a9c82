// Source: the cross-entropy method (Rubinstein 1999), with added noise that fades (Szita and Lorincz 2006), so
// that the deviations do not shrink before the means have arrived.
#include "cross_entropy.hpp"

#include <algorithm>
#include <cmath>

namespace mixed_palletizing::planning {
namespace {

constexpr double kKept = 0.1;          ///< share of the old deviation in the new
constexpr double kNoiseHalving = 7.0;  ///< the noise is halved every so many generations

}  // namespace

CrossEntropy::CrossEntropy(const PolicyWeights& mean, double spread, double noise, std::uint64_t seed)
    : mean_(mean), noise_(noise), random_(seed) {
  deviation_.fill(spread);
}

std::vector<PolicyWeights> CrossEntropy::draw(std::size_t count) {
  std::vector<PolicyWeights> drawn(count, mean_);
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t k = 0; k < mean_.size(); ++k) drawn[i][k] += deviation_[k] * packing::normal(random_);
  }
  return drawn;
}

void CrossEntropy::follow(std::vector<TriedWeights> tried, std::size_t elite) {
  std::stable_sort(tried.begin(), tried.end(),
                   [](const TriedWeights& a, const TriedWeights& b) { return a.value > b.value; });
  tried.resize(std::min(tried.size(), elite));
  const auto n = static_cast<double>(tried.size());
  const double noise = noise_ * std::exp2(-generation_++ / kNoiseHalving);
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    double sum = 0.0;
    double squares = 0.0;
    for (const TriedWeights& one : tried) sum += one.weights[i];
    mean_[i] = sum / n;
    for (const TriedWeights& one : tried)
      squares += (one.weights[i] - mean_[i]) * (one.weights[i] - mean_[i]);
    deviation_[i] = (1.0 - kKept) * std::sqrt(squares / n) + kKept * deviation_[i] + noise;
  }
}

}  // namespace mixed_palletizing::planning
