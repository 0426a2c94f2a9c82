// What a torture test tried and lost, and the line by which scripts/torture.sh puts it in its table.
#pragma once

#include <cstdio>
#include <map>
#include <optional>
#include <string>

namespace mixed_palletizing::torture {

/// Counts cases. `lost`: those with a fault.
struct Cases {
  long tried = 0;
  long lost = 0;
  std::string first_lost;
  std::map<std::string, long> kinds;  ///< of cases, where there are several

  void add(const std::string& fault, long cases = 1) {
    tried += cases;
    if (!fault.empty() && lost++ == 0) first_lost = fault;
  }
};

/// The line for the table. `slowest_s`: of what has to recover.
inline void printRow(const std::string& test, long tried, long lost, std::optional<double> slowest_s = {}) {
  char slowest[32] = "null";
  if (slowest_s) std::snprintf(slowest, sizeof slowest, "%.3f", *slowest_s);
  std::printf(
      "ROW {\"test\": \"%s\", \"tried\": %ld, \"survived\": %ld, \"lost\": %ld, \"p99_s\": null, "
      "\"slowest_s\": "
      "%s}\n",
      test.c_str(), tried, tried - lost, lost, slowest);
  std::fflush(stdout);
}

/// Prints what was counted and the line; 1 when something was lost, else 0.
inline int report(const std::string& test, const Cases& cases) {
  std::printf("%s: %ld tried, %ld lost\n", test.c_str(), cases.tried, cases.lost);
  for (const auto& [kind, count] : cases.kinds) std::printf("  %7ld %s\n", count, kind.c_str());
  if (cases.lost > 0) std::printf("first lost: %s\n", cases.first_lost.c_str());
  printRow(test, cases.tried, cases.lost);
  return cases.lost > 0 ? 1 : 0;
}

}  // namespace mixed_palletizing::torture
