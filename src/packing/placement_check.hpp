// The rules of a placement, judged from the placed boxes alone.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/packing/types.hpp>

namespace mixed_palletizing::packing {

/// The first rule that `placement` breaks on a pallet with `placed`, with the numbers; empty when none.
std::string brokenRule(const PalletRules& rules, const std::vector<Placement>& placed,
                       const Placement& placement);

/// Whether it breaks none, without the words.
bool keepsRules(const PalletRules& rules, const std::vector<Placement>& placed, const Placement& placement);

/// Of these only those of the support: share and centre.
bool isSupported(const PalletRules& rules, const std::vector<Placement>& placed, const Placement& placement);

}  // namespace mixed_palletizing::packing
