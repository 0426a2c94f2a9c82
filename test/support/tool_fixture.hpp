// Base of tests that run a tool as a user runs it.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace mixed_palletizing::test {

/// A temporary folder for each test, and the tool's exit code, output and error.
class ToolFixture : public ::testing::Test {
 protected:
  explicit ToolFixture(const std::string& tool) : tool_(tool) {
    folder_ = std::filesystem::temp_directory_path() /
              ("mixed_palletizing_" + std::filesystem::path(tool).filename().string() + "_" +
               std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~ToolFixture() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Content of a file of the folder; empty when it is not there.
  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
  }

  void write(const std::string& name, const std::string& text) const { std::ofstream(path(name)) << text; }

  /// Runs a tool in a shell; its exit code, -1 after a signal. What it prints is in out.txt and err.txt.
  int runTool(const std::string& tool, const std::string& arguments) const {
    const std::string command =
        tool + " " + arguments + " > " + path("out.txt") + " 2> " + path("err.txt") + " < /dev/null";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int run(const std::string& arguments) const { return runTool(tool_, arguments); }

  /// The tool fails with one line on stderr that holds `words`.
  void expectOneClearLine(const std::string& tool, const std::string& arguments,
                          const std::string& words) const {
    SCOPED_TRACE(tool + " " + arguments);
    EXPECT_GT(runTool(tool, arguments), 0);
    const std::string error = read("err.txt");
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
    EXPECT_NE(error.find(words), std::string::npos) << error;
  }
  void expectOneClearLine(const std::string& arguments, const std::string& words) const {
    expectOneClearLine(tool_, arguments, words);
  }

 private:
  std::string tool_;
  std::filesystem::path folder_;
};

}  // namespace mixed_palletizing::test
