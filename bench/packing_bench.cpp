// Throughput of the packing core: boxes placed by DBLF, insert and undo, copies, evaluations of the genetic search.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include <mixed_palletizing/instances/generator.hpp>
#include <mixed_palletizing/packing/genetic_search.hpp>
#include <mixed_palletizing/packing/key_genetic_search.hpp>
#include <mixed_palletizing/packing/pallet_state.hpp>
#include <mixed_palletizing/packing/placement_rule.hpp>

namespace {

using namespace mixed_palletizing;

constexpr std::uint64_t kSeed = 1;

/// An order of about `boxes` thesis-like boxes in order of arrival: footprints get finer as the count grows.
instances::Instance dividedOrder(int boxes, std::uint64_t index) {
  instances::GeneratorOptions options;
  options.pallet = {1200, 800, 1200};
  if (boxes > 100) options.footprint_divisors = {32, 64, 128};
  return instances::generateInstance(options, kSeed, static_cast<int>(index));
}

/// `boxes` boxes of as many sizes, together about 1.3 times the pallet's volume.
packing::Order mixedOrder(int boxes) {
  std::mt19937_64 rng(kSeed);
  packing::Order order;
  order.rules.size = {1200, 800, 1600};
  const double side = std::cbrt(1.3 * static_cast<double>(packing::volume(order.rules.size)) / boxes);
  const auto draw = [&] {
    return static_cast<int>(side * std::uniform_real_distribution<double>(0.6, 1.4)(rng));
  };
  for (int i = 0; i < boxes; ++i) {
    order.types.push_back({std::to_string(i), {draw(), draw(), draw()}, packing::Rotations::yawOnly()});
    order.counts.push_back(1);
  }
  return order;
}

void packAgain(benchmark::State& state, const packing::PalletState& start,
               const std::vector<packing::ItemType>& types, const std::vector<int>& items) {
  std::size_t placed = 0;
  for (auto _ : state) {
    const auto result = packing::packSequence(start, types, items, packing::PlacementRule::kDblf);
    placed += result.placements.size();
    benchmark::DoNotOptimize(placed);
  }
  state.counters["items"] = static_cast<double>(items.size());
  state.counters["boxes/s"] = benchmark::Counter(static_cast<double>(placed), benchmark::Counter::kIsRate);
}

void BM_DblfDividedSizes(benchmark::State& state) {
  const instances::Instance instance = dividedOrder(static_cast<int>(state.range(0)), 0);
  packAgain(state, packing::PalletState(instance.order.rules), instance.order.types, instance.arrival);
}
BENCHMARK(BM_DblfDividedSizes)->Arg(50)->Arg(500);

void BM_DblfMixedSizes(benchmark::State& state) {
  const packing::Order order = mixedOrder(static_cast<int>(state.range(0)));
  packAgain(state, packing::PalletState(order.rules), order.types, instances::expandedItems(order));
}
BENCHMARK(BM_DblfMixedSizes)->Arg(50)->Arg(100)->Arg(200)->Arg(500)->Arg(1000);

/// The naive space list beside it: all spaces worked out anew from the placed boxes after every box.
void BM_DblfSpacesFromScratch(benchmark::State& state) {
  const packing::Order order = mixedOrder(static_cast<int>(state.range(0)));
  std::size_t placed = 0;
  for (auto _ : state) {
    std::vector<packing::Placement> placements;
    for (const int item : instances::expandedItems(order)) {
      packing::PalletState pallet(order);
      for (const packing::Placement& p : placements) pallet.place(p);
      const auto found = packing::findPlacement(pallet, order.types[static_cast<std::size_t>(item)], item,
                                                packing::PlacementRule::kDblf);
      if (found) placements.push_back(*found);
    }
    placed += placements.size();
  }
  state.counters["boxes/s"] = benchmark::Counter(static_cast<double>(placed), benchmark::Counter::kIsRate);
}
BENCHMARK(BM_DblfSpacesFromScratch)->Arg(50)->Arg(500);

/// The list of all empty maximal spaces, whether supported or not.
void BM_DblfEmptySpaces(benchmark::State& state) {
  const packing::Order order = mixedOrder(static_cast<int>(state.range(0)));
  packAgain(state, packing::PalletState(order, packing::SpaceKind::kEmpty), order.types,
            instances::expandedItems(order));
}
BENCHMARK(BM_DblfEmptySpaces)->Arg(50)->Arg(500);

/// Every type limits the load on its top.
void BM_DblfLoads(benchmark::State& state) {
  packing::Order order = mixedOrder(static_cast<int>(state.range(0)));
  for (packing::ItemType& type : order.types) {
    type.weight_kg = 5.0;
    type.max_load_kg = 60.0;
  }
  packAgain(state, packing::PalletState(order), order.types, instances::expandedItems(order));
}
BENCHMARK(BM_DblfLoads)->Arg(50)->Arg(500);

/// The first half of an order on the pallet.
packing::PalletState halfPacked(const packing::Order& order, const std::vector<int>& items) {
  packing::PalletState pallet(order.rules);
  const std::vector<int> half(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(items.size() / 2));
  for (const packing::Placement& p :
       packing::packSequence(pallet, order.types, half, packing::PlacementRule::kDblf).placements) {
    pallet.place(p);
  }
  return pallet;
}

void BM_PlaceAndUndo(benchmark::State& state) {
  const packing::Order order = mixedOrder(static_cast<int>(state.range(0)));
  packing::PalletState pallet = halfPacked(order, instances::expandedItems(order));
  std::vector<packing::Placement> placements;
  for (std::size_t t = order.types.size() / 2; t < order.types.size(); ++t) {
    const auto found = packing::cornerPlacements(pallet, order.types[t], static_cast<int>(t));
    placements.insert(placements.end(), found.begin(), found.end());
  }
  std::size_t i = 0;
  for (auto _ : state) {
    pallet.place(placements[i]);
    pallet.undo();
    i = (i + 1) % placements.size();
  }
  state.counters["spaces"] = static_cast<double>(pallet.spaces().size());
}
BENCHMARK(BM_PlaceAndUndo)->Arg(50)->Arg(500);

void BM_CopyState(benchmark::State& state) {
  const packing::Order order = mixedOrder(static_cast<int>(state.range(0)));
  const packing::PalletState pallet = halfPacked(order, instances::expandedItems(order));
  for (auto _ : state) {
    packing::PalletState copy = pallet;
    benchmark::DoNotOptimize(copy);
  }
}
BENCHMARK(BM_CopyState)->Arg(50)->Arg(500);

void BM_GeneticSearch(benchmark::State& state) {
  std::int64_t evaluations = 0;
  std::uint64_t index = 0;
  for (auto _ : state) {
    state.PauseTiming();
    instances::GeneratorOptions generator;
    generator.pallet.z = static_cast<int>(state.range(0));
    const instances::Instance instance =
        instances::generateInstance(generator, kSeed, static_cast<int>(index++ % 50));
    packing::GeneticOptions options;
    options.population = 30;
    options.generations = 10;
    state.ResumeTiming();
    packing::geneticSearch(packing::PalletState(instance.order.rules), instance.order.types, instance.arrival,
                           options, 8, [&] { return ++evaluations, false; });
  }
  state.counters["evaluations/s"] =
      benchmark::Counter(static_cast<double>(evaluations), benchmark::Counter::kIsRate);
}
BENCHMARK(BM_GeneticSearch)->Arg(600)->Arg(800)->Arg(1200)->Unit(benchmark::kMillisecond);

void BM_RandomKeySearch(benchmark::State& state) {
  std::int64_t evaluations = 0;
  std::uint64_t index = 0;
  for (auto _ : state) {
    state.PauseTiming();
    instances::GeneratorOptions generator;
    generator.pallet.z = static_cast<int>(state.range(0));
    const instances::Instance instance =
        instances::generateInstance(generator, kSeed, static_cast<int>(index++ % 50));
    packing::KeyGeneticOptions options;
    options.generations = 10;
    state.ResumeTiming();
    packing::keyGeneticSearch(packing::PalletState(instance.order), instance.order.types, instance.arrival,
                              options, [&] { return ++evaluations, false; });
  }
  state.counters["evaluations/s"] =
      benchmark::Counter(static_cast<double>(evaluations), benchmark::Counter::kIsRate);
}
BENCHMARK(BM_RandomKeySearch)->Arg(600)->Arg(1200)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
