// Figures over the results of many instances.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/instances/packing_result.hpp>

namespace mixed_palletizing::instances {

/// Median, 99th percentile (nearest rank) and maximum of times [ms]; zeros when there are none.
DecisionTimes decisionTimes(std::vector<double> times_ms);

class ResultSummary {
 public:
  /// `decision_ms` [ms] are the times of all decisions of this result; may be empty.
  void add(const PackingResult& result, const std::vector<double>& decision_ms);

  int orders() const { return orders_; }
  double perfectRatio() const;     ///< share of the orders without an unpacked item
  double meanUnpacked() const;     ///< items per order
  double meanUtilization() const;  ///< [0, 1]
  DecisionTimes times() const { return decisionTimes(decision_ms_); }

  /// How many decisions took longer than their budget and 10 ms, or 5 % where that is more.
  int late(double budget_ms) const;

  /// "orders 50  perfect 52.0 %  mean unpacked 0.70  mean utilization 97.81 %  decision ms median .. p99 .. max .."
  /// and, with the budget [ms] of a decision, " late .."
  std::string text(double budget_ms = 0.0) const;

 private:
  int orders_ = 0;
  int perfect_ = 0;
  std::size_t unpacked_ = 0;
  double utilization_ = 0.0;
  std::vector<double> decision_ms_;
};

}  // namespace mixed_palletizing::instances
