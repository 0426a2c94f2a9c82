// Journals of any bytes: opened at a state that follows from their events, or refused with a JournalError.
#include <filesystem>

#include <mixed_palletizing/planning/pallet_journal.hpp>

#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace planning = mixed_palletizing::planning;
  static const mixed_palletizing::fuzz::ScratchFolder folder;
  const std::string path = folder.write("journal.sqlite", data, size);
  for (const char* companion : {"-wal", "-shm"}) std::filesystem::remove(path + companion);
  try {
    planning::PalletJournal(path, 10).restore();
    planning::readJournal(path);
  } catch (const planning::JournalError&) {
  }
  return 0;
}
