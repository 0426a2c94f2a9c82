#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <mixed_palletizing/instances/result_summary.hpp>

namespace mixed_palletizing::instances {
namespace {

double ratio(double sum, int count) { return count == 0 ? 0.0 : sum / count; }

}  // namespace

DecisionTimes decisionTimes(std::vector<double> times_ms) {
  if (times_ms.empty()) return {};
  std::sort(times_ms.begin(), times_ms.end());
  const auto atRank = [&times_ms](double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(times_ms.size())));
    return times_ms[std::max<std::size_t>(rank, 1) - 1];
  };
  return {atRank(0.5), atRank(0.99), times_ms.back()};
}

void ResultSummary::add(const PackingResult& result, const std::vector<double>& decision_ms) {
  ++orders_;
  if (result.unpacked.empty()) ++perfect_;
  unpacked_ += result.unpacked.size();
  utilization_ += result.utilization;
  decision_ms_.insert(decision_ms_.end(), decision_ms.begin(), decision_ms.end());
}

double ResultSummary::perfectRatio() const { return ratio(perfect_, orders_); }
double ResultSummary::meanUnpacked() const { return ratio(static_cast<double>(unpacked_), orders_); }
double ResultSummary::meanUtilization() const { return ratio(utilization_, orders_); }

int ResultSummary::late(double budget_ms) const {
  constexpr double kGraceMs = 10.0;
  constexpr double kGraceShare = 0.05;
  const double latest = budget_ms + std::max(kGraceMs, kGraceShare * budget_ms);
  return static_cast<int>(
      std::count_if(decision_ms_.begin(), decision_ms_.end(), [latest](double ms) { return ms > latest; }));
}

std::string ResultSummary::text(double budget_ms) const {
  std::ostringstream out;
  out << std::fixed << "orders " << orders_ << std::setprecision(1) << "  perfect " << 100.0 * perfectRatio()
      << " %" << std::setprecision(2) << "  mean unpacked " << meanUnpacked() << "  mean utilization "
      << 100.0 * meanUtilization() << " %";
  if (!decision_ms_.empty()) {
    const DecisionTimes ms = times();
    out << "  decision ms median " << ms.median_ms << " p99 " << ms.p99_ms << " max " << ms.max_ms;
    if (budget_ms > 0.0) out << " late " << late(budget_ms);
  }
  return out.str();
}

}  // namespace mixed_palletizing::instances
