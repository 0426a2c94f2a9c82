// Journals: any file opens at a state that follows from its events, or is refused with a JournalError; and, as a checksum
// keeps nearly every changed file from getting that far, any events (inputs that begin with '[') are applied or refused.
#include <filesystem>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include <mixed_palletizing/planning/pallet_journal.hpp>

#include "event_json.hpp"
#include "scratch_file.hpp"

namespace {

namespace planning = mixed_palletizing::planning;

/// [[kind, body], ...], as the rows of a journal have them.
void applyEvents(const std::uint8_t* data, std::size_t size) {
  nlohmann::json rows;
  try {
    rows = planning::parseEvent({reinterpret_cast<const char*>(data), size});
  } catch (const std::invalid_argument&) {
  } catch (const nlohmann::json::exception&) {
  }
  if (!rows.is_array()) return;
  planning::SessionState state;
  for (const nlohmann::json& row : rows) {
    try {
      const planning::SessionEvent event = planning::eventFromJson(row.at(0).get<std::string>(), row.at(1));
      state.apply(event);
      // What was understood must be written and read again.
      planning::eventFromJson(planning::kindOf(event), planning::toJson(event));
    } catch (const std::invalid_argument&) {
    } catch (const nlohmann::json::exception&) {
    }
  }
}

void openFile(const std::uint8_t* data, std::size_t size) {
  static const mixed_palletizing::fuzz::ScratchFolder folder;
  const std::string path = folder.write("journal.sqlite", data, size);
  for (const char* companion : {"-wal", "-shm"}) std::filesystem::remove(path + companion);
  try {
    planning::PalletJournal(path, 10).restore();
    planning::readJournal(path);
  } catch (const planning::JournalError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 0 && data[0] == '[') {
    applyEvents(data, size);
  } else {
    openFile(data, size);
  }
  return 0;
}
