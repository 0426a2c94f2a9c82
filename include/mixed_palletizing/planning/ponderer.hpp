// Thinks about the next decisions while the robot moves, in one thread of its own.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include <mixed_palletizing/planning/next_pick.hpp>

namespace mixed_palletizing::planning {

/// A situation that may be asked about next.
struct ExpectedWorld {
  std::shared_ptr<const packing::PalletState> pallet;
  std::shared_ptr<const std::vector<packing::ItemType>> types;
  std::vector<int> available;
  std::vector<int> remaining;
  std::vector<double> forecast;
  std::uint64_t seed = 1;

  Situation situation() const { return {*pallet, *types, available, remaining, forecast}; }
};

/// Only PlanMethod::kBest is worth it, and only its decisions do not depend on the sequence of the available
/// items: with another method nothing is ever known.
class Ponderer {
 public:
  explicit Ponderer(const PlannerOptions& options);
  /// Ends the thread; waits only for the next look at its stop flag.
  ~Ponderer();
  Ponderer(const Ponderer&) = delete;
  Ponderer& operator=(const Ponderer&) = delete;

  /// Forgets what it thought and thinks about these worlds, one after the other, each for `budget_ms`, or to its
  /// end when BestOptions::samples is given. The first begins with the weights `fitted`, the others with what the one
  /// before came to. Does not wait.
  void expect(std::vector<ExpectedWorld> worlds, double budget_ms,
              const std::optional<PolicyWeights>& fitted = std::nullopt);

  /// Forgets everything. Does not wait.
  void forget();

  /// The decision of this situation with this seed, if it was among the expected ones and was thought about for
  /// `budget_ms` at least or to its end. When its turn is now, waits for it, at most until `stop`. Otherwise the
  /// answer is std::nullopt at once. Forgets the rest either way. With BestOptions::samples the decision is the
  /// one that chooseNextPick() makes; with neither samples nor `stop` nothing is known.
  std::optional<Decision> take(const Situation& situation, std::uint64_t seed, double budget_ms,
                               const packing::StopCallback& stop);

  /// The weights that the last of the thoughts came to (BestOptions::fitted): they play the order, whatever comes next.
  std::optional<PolicyWeights> fitted() const;

 private:
  struct Thought;

  void run();
  std::shared_ptr<Thought> find(const Situation& situation, std::uint64_t seed) const;
  void drop();

  const PlannerOptions options_;
  const bool others_think_faster_;
  mutable std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::vector<std::shared_ptr<Thought>> thoughts_;
  std::optional<PolicyWeights> fitted_;
  bool quit_ = false;
  std::thread thread_;
};

}  // namespace mixed_palletizing::planning
