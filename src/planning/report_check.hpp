// Whether a report suits the decision it is about.
#pragma once

#include <string>

#include <mixed_palletizing/planning/session_state.hpp>

namespace mixed_palletizing::planning {

/// Why the report does not suit its decision; empty when it does.
std::string reportProblem(const PickDecided& decided, const PickReported& report, const OpenPallet& open);

}  // namespace mixed_palletizing::planning
