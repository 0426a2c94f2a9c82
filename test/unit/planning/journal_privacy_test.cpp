// The journal's files are their user's alone.
#include <filesystem>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "journal_support.hpp"

namespace mixed_palletizing::planning {
namespace {

namespace fs = std::filesystem;

using test::act;
using test::Recorded;

/// How many files are beside the journal; each must be its user's alone.
int privateFiles(const std::string& path) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(path).parent_path())) {
    struct stat status {};
    EXPECT_EQ(::stat(entry.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0077U, 0U) << entry.path();
    ++files;
  }
  return files;
}

TEST(JournalPrivacy, onlyItsUserCanReadIt) {
  const fs::path folder = fs::path(::testing::TempDir()) / ("privacy_" + std::to_string(::getpid()));
  const std::string path = (folder / "p.journal").string();
  std::mt19937_64 rng(92);
  const mode_t before = ::umask(0);
  {
    Recorded recorded(path);
    for (int i = 0; i < 5; ++i) act(recorded.session, rng);
    EXPECT_EQ(privateFiles(path), 4) << "journal, -wal, -shm, .lock";
  }
  // A copy that was brought back may be open to all.
  fs::permissions(path, fs::perms::all);
  {
    Recorded recorded(path);
    act(recorded.session, rng);
    EXPECT_GE(privateFiles(path), 2);
  }
  ::umask(before);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace mixed_palletizing::planning
