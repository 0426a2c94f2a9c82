// Do decisions keep their budget? By the wall clock, and by the processor time of the deciding thread.
#include <chrono>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <string>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/instances/result_summary.hpp>

#include "deadline_worlds.hpp"

namespace bench = mixed_palletizing::bench;
namespace planning = mixed_palletizing::planning;

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kDecisionsPerWorld = 20;
constexpr double kLateMs = 10.0;
constexpr double kLateShare = 0.05;

double wallMs() { return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count(); }

double processorMs() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

struct Times {
  std::vector<double> wall;
  std::vector<double> processor;
  int late = 0;            ///< by the wall clock
  int late_processor = 0;  ///< by the thread's own time: what nobody else on the machine can be blamed for

  void add(double wall_ms, double processor_ms, double budget_ms) {
    const double latest = budget_ms + std::max(kLateMs, kLateShare * budget_ms);
    wall.push_back(wall_ms);
    processor.push_back(processor_ms);
    late += wall_ms > latest ? 1 : 0;
    late_processor += processor_ms > latest ? 1 : 0;
  }

  void print(const std::string& what) const {
    const auto w = mixed_palletizing::instances::decisionTimes(wall);
    const auto p = mixed_palletizing::instances::decisionTimes(processor);
    std::printf(
        "%-22s %6zu decisions  wall ms median %.1f p99 %.1f max %.1f late %d  processor ms p99 %.1f max %.1f "
        "late %d\n",
        what.c_str(), wall.size(), w.median_ms, w.p99_ms, w.max_ms, late, p.p99_ms, p.max_ms, late_processor);
    std::fflush(stdout);
  }
};

Times measure(bench::WorldKind kind, int decisions, double budget_ms, std::mt19937_64& rng) {
  Times times;
  while (static_cast<int>(times.wall.size()) < decisions) {
    const bench::World world = bench::randomWorld(rng, kind);
    planning::PalletSession session(world.options, world.state);
    for (int i = 0; i < kDecisionsPerWorld && static_cast<int>(times.wall.size()) < decisions; ++i) {
      const std::vector<int> available = world.draw(rng, kind);
      if (available.empty()) break;
      const double processor = processorMs();
      const double begin = wallMs();
      session.choose("", available, [&] { return wallMs() >= begin + budget_ms; });
      const double end = wallMs();
      times.add(end - begin, processorMs() - processor, budget_ms);
    }
  }
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  int decisions = 8000, large = 1000, many = 1000;
  double budget_ms = 10.0;
  std::uint64_t seed = 1;
  mixed_palletizing::adapters::CommandLine line(
      "decision_deadlines", "Counts decisions later than their budget + 10 ms (or 5 %), over random states.");
  line.option("usual", &decisions, "decisions in orders of the generator, 1 to 10 boxes visible");
  line.option("large", &large, "in orders of thousands of boxes, up to 100 visible");
  line.option("many", &many, "with 10,000 boxes visible");
  line.option("budget_ms", &budget_ms, "of each");
  line.option("seed", &seed, "of the states");
  return line.run(argc, argv, [&] {
    if (!(budget_ms > 0.0)) throw std::invalid_argument("budget_ms: must be above 0");
    std::mt19937_64 rng(seed);
    int late = 0;
    for (const auto& [kind, count] : {std::pair{bench::WorldKind::kUsual, decisions},
                                      {bench::WorldKind::kLargeOrder, large},
                                      {bench::WorldKind::kManyBoxes, many}}) {
      const Times times = measure(kind, count, budget_ms, rng);
      if (!times.wall.empty()) times.print(bench::toString(kind));
      late += times.late;
    }
    return late == 0 ? 0 : 1;
  });
}
