// Data sets: the same bytes whatever the threads and interruptions, nothing half, nothing mixed.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <mixed_palletizing/adapters/captures/dataset.hpp>
#include <mixed_palletizing/adapters/progress_line.hpp>

namespace mixed_palletizing::captures {
namespace {

namespace fs = std::filesystem;

const char* const kRecipe =
    "camera: {width_px: 64, height_px: 40, projector_m: [0.1, 0, 0]}\n"
    "noise: {depth_stddev_at_1m_m: 0.0003, no_data_on_black: true, dropout_ratio: 0.01, flying_pixel_ratio: "
    "0.5}\n"
    "groups: [{arrangement: apart, count: [1, 3]}]\n";

class Dataset : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("mixed_palletizing_dataset_" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write("r.yaml", kRecipe);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  DatasetOptions options(const std::string& out, int threads = 1) const {
    DatasetOptions options;
    options.recipe = path("r.yaml");
    options.out = path(out);
    options.count = 6;
    options.seed = 5;
    options.threads = threads;
    options.bag = true;
    return options;
  }

  /// Content by path relative to the folder.
  std::map<std::string, std::string> contents(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path(name))) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path(), std::ios::binary);
      std::ostringstream text;
      text << file.rdbuf();
      files[fs::relative(entry.path(), path(name)).string()] = text.str();
    }
    return files;
  }

  void expectSame(const std::string& one, const std::string& two) const {
    const auto a = contents(one);
    const auto b = contents(two);
    ASSERT_EQ(a.size(), b.size());
    for (const auto& [name, text] : a) {
      ASSERT_EQ(b.count(name), 1u) << name;
      EXPECT_TRUE(text == b.at(name)) << name;
    }
  }

  static std::string errorOf(const DatasetOptions& options) {
    try {
      writeDataset(options, {});
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  }

 private:
  fs::path folder_;
};

TEST_F(Dataset, TheThreadsDoNotMatter) {
  EXPECT_EQ(writeDataset(options("one", 1), {}).written, 6);
  EXPECT_EQ(writeDataset(options("two", 2), {}).written, 6);
  EXPECT_EQ(contents("one").size(), 1u + 6u * 7u);
  expectSame("one", "two");
  DatasetOptions other = options("other");
  other.seed = 6;
  writeDataset(other, {});
  EXPECT_FALSE(contents("one").at("000000/cloud.pcd") == contents("other").at("000000/cloud.pcd"));
  EXPECT_FALSE(contents("one").at("000000/cloud.pcd") == contents("one").at("000001/cloud.pcd"));
}

TEST_F(Dataset, AnEndedRunIsContinued) {
  writeDataset(options("whole"), {});
  DatasetOptions part = options("part");
  part.count = 2;
  writeDataset(part, {});
  fs::create_directory(path("part/000002.unfinished"));  // what a killed run leaves
  write("part/000002.unfinished/cloud.pcd", "half");
  const DatasetResult result = writeDataset(options("part"), {});
  EXPECT_EQ(result.found, 2);
  EXPECT_EQ(result.written, 4);
  expectSame("whole", "part");
  EXPECT_EQ(writeDataset(options("part"), {}).written, 0);
}

TEST_F(Dataset, TellsHowFarItIs) {
  std::vector<int> steps;
  writeDataset(options("a", 2), [&](int done, int total) {
    EXPECT_EQ(total, 6);
    steps.push_back(done);
  });
  EXPECT_EQ(steps, (std::vector<int>{0, 1, 2, 3, 4, 5, 6}));
}

TEST_F(Dataset, RefusesToMix) {
  writeDataset(options("a"), {});
  DatasetOptions other = options("a");
  other.seed = 6;
  EXPECT_NE(errorOf(other).find("a data set of another seed (5, not 6)"), std::string::npos)
      << errorOf(other);
  other = options("a");
  other.layout = adapters::CloudLayout::kXyz;
  EXPECT_NE(errorOf(other).find("another layout"), std::string::npos) << errorOf(other);
  other = options("a");
  other.bag = false;
  EXPECT_NE(errorOf(other).find("another bag"), std::string::npos) << errorOf(other);
  write("r.yaml", std::string(kRecipe) + "boxes: {gap_m: 0.05}\n");
  EXPECT_NE(errorOf(options("a")).find("another text of the recipe"), std::string::npos);
  fs::create_directory(path("mine"));
  write("mine/letter.txt", "dear");
  EXPECT_NE(errorOf(options("mine")).find("is neither empty nor a data set"), std::string::npos);
  EXPECT_EQ(contents("mine").size(), 1u);
}

TEST_F(Dataset, OneRunAtATime) {
  fs::create_directory(path("a"));
  const int handle = ::open(path("a").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(handle, LOCK_EX), 0);
  EXPECT_NE(errorOf(options("a")).find("another run is writing to it"), std::string::npos);
  ::close(handle);
  EXPECT_EQ(errorOf(options("a")), "");
}

TEST_F(Dataset, NamesWhatIsWrong) {
  DatasetOptions wrong = options("a");
  wrong.count = 0;
  wrong.threads = 0;
  wrong.cloud = "xyz";
  EXPECT_EQ(problems(wrong).size(), 3u);
  EXPECT_NE(errorOf(wrong).find("count: 0 is not in"), std::string::npos);
  wrong = options("a");
  wrong.recipe = path("none.yaml");
  EXPECT_NE(errorOf(wrong).find("none.yaml: cannot be read"), std::string::npos);
  write("r.yaml", "groups: 3\n");
  EXPECT_NE(errorOf(options("a")).find("r.yaml:1: groups: is no list"), std::string::npos);
  EXPECT_FALSE(fs::exists(path("a")));
  write("file", "");
  write("r.yaml", kRecipe);
  EXPECT_NE(errorOf(options("file/a")).find("cannot make the folder"), std::string::npos);
}

/// No file may grow beyond this for as long as it lives: writing fails as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    rlimit limit = before_;
    limit.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int) = nullptr;
};

TEST_F(Dataset, AFullDiskLeavesNothingHalf) {
  writeDataset(options("whole"), {});
  for (const rlim_t bytes : {100u, 3000u, 9000u, 30000u, 60000u}) {
    SCOPED_TRACE("limit " + std::to_string(bytes));
    fs::remove_all(path("full"));
    std::string error;
    {
      const FileSizeLimit limit(bytes);
      error = errorOf(options("full", 2));
    }
    EXPECT_NE(error.find(path("full")), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    const auto whole = contents("whole");
    for (const auto& [name, text] : contents("full")) {
      const bool is_finished = name.find(".unfinished") == std::string::npos;
      EXPECT_TRUE(!is_finished || text == whole.at(name)) << name;
    }
    writeDataset(options("full", 2), {});
    expectSame("whole", "full");
  }
}

TEST(ProgressText, ShowsShareAndTimeLeft) {
  EXPECT_EQ(adapters::progressText(0, 0, 10, "scenes", 0.0), "[------------------------] 0 of 10 scenes");
  EXPECT_EQ(adapters::progressText(0, 5, 10, "scenes", 65.0),
            "[############------------] 5 of 10 scenes, 1:05 left");
  EXPECT_EQ(adapters::progressText(5, 6, 10, "scenes", 1000.0),
            "[##############----------] 6 of 10 scenes, 1:06:40 left");
  EXPECT_EQ(adapters::progressText(0, 10, 10, "scenes", 9.0), "[########################] 10 of 10 scenes");
}

}  // namespace
}  // namespace mixed_palletizing::captures
