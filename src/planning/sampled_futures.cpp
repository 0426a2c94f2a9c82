#include "sampled_futures.hpp"

#include <algorithm>
#include <cmath>

#include <mixed_palletizing/packing/random.hpp>

namespace mixed_palletizing::planning {
namespace {

/// One seed per future (splitmix64, Steele, Lea and Flood 2014).
std::uint64_t futureSeed(std::uint64_t seed, std::uint64_t future) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL * (future + 1);
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31U);
}

}  // namespace

PlayoutStart playoutStart(const Situation& situation) {
  PlayoutStart start{situation.pallet, std::vector<int>(situation.types.size(), 0),
                     static_cast<int>(situation.available.size())};
  for (const int type : situation.available) ++start.visible[static_cast<std::size_t>(type)];
  return start;
}

SampledFutures::SampledFutures(const Situation& situation, std::uint64_t seed)
    : forecast_(situation.forecast), seed_(seed) {
  std::vector<int> counts = situation.remaining;
  for (const int type : situation.available) --counts[static_cast<std::size_t>(type)];
  for (std::size_t t = 0; t < counts.size(); ++t) {
    to_come_.insert(to_come_.end(), static_cast<std::size_t>(counts[t]), static_cast<int>(t));
  }
}

std::vector<int> SampledFutures::arrival(std::size_t future) const {
  packing::Random random(futureSeed(seed_, future));
  const auto gap = [&random] { return -std::log(1.0 - packing::uniform01(random)); };
  std::vector<int> arrival = to_come_;
  for (std::size_t t = 0; t < forecast_.size(); ++t) {
    for (double time = gap(); time < forecast_[t]; time += gap()) arrival.push_back(static_cast<int>(t));
  }
  packing::shuffle(arrival, random);
  return arrival;
}

bool SampledFutures::onlyOne() const {
  const bool alike = to_come_.empty() || to_come_.front() == to_come_.back();
  return alike && std::all_of(forecast_.begin(), forecast_.end(), [](double count) { return count == 0.0; });
}

}  // namespace mixed_palletizing::planning
