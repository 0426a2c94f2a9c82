// Throughput of the planner: futures played, decisions by method.
#include <random>

#include <benchmark/benchmark.h>

#include <mixed_palletizing/instances/generator.hpp>
#include <mixed_palletizing/packing/random.hpp>
#include <mixed_palletizing/planning/next_pick.hpp>
#include <mixed_palletizing/planning/playout.hpp>

namespace {

using namespace mixed_palletizing;

constexpr std::uint64_t kSeed = 1;

instances::Instance orderOf(int height, bool cuts) {
  instances::GeneratorOptions options;
  options.pallet.z = height;
  if (cuts) {
    options.structure = instances::PackingStructure::kCuts;
    options.rotations = packing::Rotations::yawOnly();
  }
  return instances::generateInstance(options, kSeed, 0);
}

/// Whole orders from the empty pallet: the longest futures there are.
void BM_Playouts(benchmark::State& state) {
  const instances::Instance instance = orderOf(static_cast<int>(state.range(0)), state.range(1) != 0);
  planning::Playout playout(instance.order.types, instance.order.rules, planning::tunedPolicyWeights());
  const planning::PlayoutStart start{packing::PalletState(instance.order),
                                     std::vector<int>(instance.order.types.size(), 0), instance.n_pick};
  std::vector<int> arrival = instance.arrival;
  packing::Random random(kSeed);
  for (auto _ : state) {
    packing::shuffle(arrival, random);
    benchmark::DoNotOptimize(playout.play(start, arrival, {}));
  }
  state.counters["items"] = static_cast<double>(arrival.size());
  state.counters["playouts/s"] =
      benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(BM_Playouts)
    ->ArgNames({"height", "cuts"})
    ->ArgsProduct({{600, 800, 1200}, {0, 1}})
    ->Unit(benchmark::kMicrosecond);

/// The first decision of an order.
void BM_Decision(benchmark::State& state) {
  const instances::Instance instance = orderOf(600, false);
  planning::PlannerOptions options;
  options.method = static_cast<planning::PlanMethod>(state.range(0));
  const planning::Situation situation{
      packing::PalletState(instance.order), instance.order.types,
      std::vector<int>(instance.arrival.begin(), instance.arrival.begin() + instance.n_pick),
      instance.order.counts};
  for (auto _ : state) {
    benchmark::DoNotOptimize(planning::chooseNextPick(situation, options, kSeed, {}));
  }
}
BENCHMARK(BM_Decision)
    ->ArgName("method")
    ->DenseRange(static_cast<int>(planning::PlanMethod::kDblf), static_cast<int>(planning::PlanMethod::kBest))
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
