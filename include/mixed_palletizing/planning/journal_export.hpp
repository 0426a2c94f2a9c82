// What a journal tells people and other programs.
#pragma once

#include <string>
#include <vector>

#include <mixed_palletizing/planning/pallet_journal.hpp>

namespace mixed_palletizing::planning {

/// The entries of the last pallet with this id, or of the last of all for an empty id. Throws
/// std::invalid_argument when there is none.
std::vector<JournalEntry> entriesOf(const std::vector<JournalEntry>& entries, const std::string& pallet_id);

/// One line for each pallet: "1  2026-01-31T12:00:00.000Z  id  12 placed, 1 discarded, 3 to come, open".
std::string palletList(const std::vector<JournalEntry>& entries);

/// One line for each event of one pallet: sequence number, time, revision, what happened.
std::string palletHistory(const std::vector<JournalEntry>& entries);

/// One pallet as a JSON object: pallet_id, revision, open (as it was before a close), order, placements in
/// loading order, remaining and discarded (counts per order line), utilization, pending (decision not yet
/// reported, or null), history.
std::string palletJson(const std::vector<JournalEntry>& entries);

}  // namespace mixed_palletizing::planning
