#include "journal_torture.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "../unit/planning/journal_support.hpp"
#include "faulty_files.hpp"

namespace mixed_palletizing::torture {
namespace {

namespace fs = std::filesystem;
using planning::JournalError;
using planning::test::act;
using planning::test::digest;
using planning::test::Recorded;

constexpr int kSteps = 40;          ///< of the journal that is damaged
constexpr int kStepsOnBadDisk = 8;  ///< of a session on a bad disk

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Opens a journal and puts the outcome in the tally. `sound`: what it may be opened as.
void open(const std::string& path, const std::vector<std::string>& sound, bool may_refuse,
          const std::string& what, Tally& tally) {
  const auto start = std::chrono::steady_clock::now();
  ++tally.tried;
  std::string fault;
  try {
    const Recorded recorded(path);
    const std::string state = digest(recorded.session);
    if (std::find(sound.begin(), sound.end(), state) == sound.end()) fault = "opened as '" + state + "'";
    ++tally.recovered;
  } catch (const JournalError& error) {
    const std::string text = error.what();
    const bool says_what_to_do =
        text.find("move it") != text.npos || text.find("see that its disk") != text.npos;
    if (!may_refuse || !says_what_to_do) fault = "refused: " + text;
    ++tally.refused;
  }
  tally.slowest_s = std::max(tally.slowest_s, secondsSince(start));
  if (fault.empty()) return;
  if (tally.lost++ == 0) tally.first_lost = what + ": " + fault + ", not as '" + sound.front() + "'";
}

/// A journal of a session, and copies of it with other contents.
class Damaged {
 public:
  Damaged(const std::string& folder, std::uint64_t seed)
      : path_(folder + "/whole.journal"), copy_(folder + "/copy.journal") {
    std::mt19937_64 rng(seed);
    {
      Recorded recorded(path_);
      for (int i = 0; i < kSteps; ++i) act(recorded.session, rng);
      whole_ = digest(recorded.session);
    }
    content_ = planning::test::bytesOf(path_);
  }

  const std::string& content() const { return content_; }

  void open(const std::string& content, const std::string& what, Tally& tally) const {
    for (const char* end : {"-wal", "-shm"}) fs::remove(copy_ + end);
    std::ofstream(copy_, std::ios::binary) << content;
    fs::copy_file(path_ + ".lock", copy_ + ".lock", fs::copy_options::overwrite_existing);
    torture::open(copy_, {whole_}, true, what, tally);
  }

 private:
  std::string path_;
  std::string copy_;
  std::string whole_;
  std::string content_;
};

void prepare(DiskFault fault, int at, std::uint64_t seed) {
  FaultyFiles& files = FaultyFiles::instance();
  switch (fault) {
    case DiskFault::kFull:
      return files.failAt(at, SQLITE_FULL, SQLITE_IOERR_FSYNC, true);
    case DiskFault::kBroken:
      return files.failAt(at, SQLITE_IOERR_WRITE, SQLITE_IOERR_FSYNC, true);
    case DiskFault::kFullForAMoment:
      return files.failAt(at, SQLITE_FULL, SQLITE_IOERR_FSYNC, false);
    case DiskFault::kBrokenForAMoment:
      return files.failAt(at, SQLITE_IOERR_WRITE, SQLITE_IOERR_FSYNC, false);
    case DiskFault::kPowerCut:
      return files.cutPowerAt(at, seed);
  }
}

/// What may be found after a session on a bad disk: the last state that was acknowledged, and what the refused
/// change would have made of it, which may have reached the disk. Throws when a refused change was made.
std::vector<std::string> workOnBadDisk(const std::string& path, std::uint64_t seed) {
  planning::PalletSession twin(planning::test::dblf());
  std::string acknowledged = digest(twin);
  std::mt19937_64 rng(seed);
  std::mt19937_64 twin_rng(seed);
  try {
    Recorded recorded(path);
    for (int i = 0; i < kStepsOnBadDisk; ++i) {
      act(twin, twin_rng);
      try {
        act(recorded.session, rng);
      } catch (const JournalError&) {
        if (digest(recorded.session) != acknowledged) throw std::logic_error("a refused change was made");
        return {acknowledged, digest(twin)};
      }
      acknowledged = digest(recorded.session);
    }
  } catch (const JournalError&) {  // did not open
  }
  return {acknowledged};
}

}  // namespace

Tally cutJournals(const std::string& folder, int step, std::uint64_t seed) {
  const Damaged damaged(folder, seed);
  Tally tally;
  for (std::size_t length = 0; length < damaged.content().size(); length += static_cast<std::size_t>(step)) {
    damaged.open(damaged.content().substr(0, length), "cut to " + std::to_string(length) + " bytes", tally);
  }
  return tally;
}

Tally flipBits(const std::string& folder, int flips, std::uint64_t seed) {
  const Damaged damaged(folder, seed);
  std::mt19937_64 rng(seed);
  Tally tally;
  for (int i = 0; i < flips; ++i) {
    std::string content = damaged.content();
    const auto at = static_cast<std::size_t>(rng() % content.size());
    const auto bit = static_cast<unsigned>(rng() % 8);
    content[at] = static_cast<char>(static_cast<unsigned char>(content[at]) ^ (1U << bit));
    damaged.open(content, "bit " + std::to_string(bit) + " of byte " + std::to_string(at), tally);
  }
  return tally;
}

Tally failDisk(const std::string& folder, DiskFault fault, int draws, std::uint64_t seed) {
  const std::string path = folder + "/bad_disk.journal";
  FaultyFiles& files = FaultyFiles::instance();
  Tally tally;
  bool reached = true;
  for (int at = 0; reached; ++at) {
    reached = false;
    for (int draw = 0; draw < draws; ++draw) {
      for (const char* end : {"", "-wal", "-shm", ".lock", ".lock-journal"}) fs::remove(path + end);
      prepare(fault, at, seed + static_cast<std::uint64_t>(draw));
      const std::vector<std::string> sound = workOnBadDisk(path, seed + static_cast<std::uint64_t>(draw));
      if (!files.happened()) continue;
      reached = true;
      if (fault == DiskFault::kPowerCut) files.restoreDisk();
      files.reset();
      // Before the first answer there is nothing to lose.
      const bool may_refuse = sound.front() == "0  ";
      open(
          path, sound, may_refuse,
          "operation " + std::to_string(at) + ", seed " + std::to_string(seed) + " + " + std::to_string(draw),
          tally);
    }
  }
  files.reset();
  return tally;
}

}  // namespace mixed_palletizing::torture
