#include <chrono>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include <mixed_palletizing/instances/files.hpp>
#include <mixed_palletizing/instances/pack_instance.hpp>
#include <mixed_palletizing/packing/several_pallets.hpp>

namespace mixed_palletizing::instances {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Ends a search after a share of the run's time or evaluations.
packing::StopCallback stopAfter(const PackRun& run, double share) {
  return [start = Clock::now(), seconds = run.time_limit_s * share,
          evaluations = static_cast<double>(run.max_evaluations) * share, asked = 0.0]() mutable {
    asked += 1.0;
    return (evaluations > 0.0 && asked > evaluations) || (seconds > 0.0 && secondsSince(start) >= seconds);
  };
}

}  // namespace

std::vector<std::string> problems(const PackRun& run) {
  std::vector<std::string> lines = packing::problems(run.options);
  if (!(run.time_limit_s >= 0.0)) lines.emplace_back("time_limit_s: must not be negative");
  if (run.max_evaluations < 0) lines.emplace_back("max_evaluations: must not be negative");
  if (run.max_pallets < 0) lines.emplace_back("max_pallets: must not be negative");
  const bool endless = run.time_limit_s == 0.0 && run.max_evaluations == 0;
  if (endless && packing::needsBudget(run.options.method)) {
    lines.emplace_back("time_limit_s, max_evaluations: this method ends only by one of them");
  }
  return lines;
}

PackingResult packInstance(const Instance& instance, const PackRun& run) {
  const std::vector<std::string> broken = problems(run);
  if (!broken.empty()) throw std::invalid_argument("packInstance: run: " + joinFaults(broken));
  const Clock::time_point start = Clock::now();
  const packing::SeveralPallets packed =
      packing::packPallets(instance.order, itemTypes(instance), run.options, run.max_pallets,
                           [&run](double share) { return stopAfter(run, share); });
  const double ms = 1000.0 * secondsSince(start);
  PackingResult result;
  result.name = instance.name;
  result.pallets = static_cast<int>(packed.pallets.size());
  for (int pallet = 0; pallet < result.pallets; ++pallet) {
    const packing::OrderPacking& load = packed.pallets[static_cast<std::size_t>(pallet)];
    result.utilization += load.utilization / result.pallets;
    for (const packing::PackedItem& item : load.packed) {
      result.placements.push_back({item.item, item.placement, {}, pallet});
    }
  }
  result.unpacked = packed.unpacked;
  result.decision_ms = {ms, ms, ms};
  result.method = run.method;
  result.seed = run.options.seed;
  return result;
}

void PackSummary::add(const Instance& instance, const PackingResult& result) {
  ++orders_;
  if (result.unpacked.empty()) ++complete_;
  pallets_ += result.pallets;
  least_pallets_ += packing::leastPallets(instance.order, itemTypes(instance));
  utilization_ += result.utilization;
}

std::string PackSummary::text() const {
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << "orders " << orders_ << "  packed completely " << complete_
      << "  pallets " << pallets_ << ", at least " << least_pallets_
      << " by volume and weight  mean utilization " << (orders_ == 0 ? 0.0 : 100.0 * utilization_ / orders_)
      << " %";
  return out.str();
}

}  // namespace mixed_palletizing::instances
