// Limits of scene files: depth, values, bytes, length of the messages.
#include <mixed_palletizing/simulation/scene_file.hpp>

#include "temporary_folder.hpp"

namespace mixed_palletizing::simulation {
namespace {

class YamlText : public TemporaryFolder {
 protected:
  Scene load(const std::string& text) const { return loadScene(write("scene.yaml", text)); }

  std::string errorOf(const std::string& text) const {
    try {
      load(text);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  }
};

std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += part;
  return text;
}

TEST_F(YamlText, deepAndHugeFilesAreRefused) {
  for (const char* part : {"[", "{a: ", "- ", "? ", "[{a: ", "&a [", "!!seq ["}) {
    SCOPED_TRACE(part);
    const std::string error = errorOf(repeated(part, 100000));
    EXPECT_NE(error.find("levels"), std::string::npos) << error.substr(0, 300);
  }
  std::string steps;
  for (int depth = 0; depth < 2000; ++depth)
    steps += std::string(static_cast<std::size_t>(depth), ' ') + "a:\n";
  EXPECT_NE(errorOf(steps).find("levels"), std::string::npos);
  EXPECT_NE(errorOf("boxes: [" + repeated("1,", 1100000) + "1]").find("values"), std::string::npos);
  EXPECT_LT(errorOf(repeated("- {}\n", 20000)).size(), 10000U);
  EXPECT_LT(errorOf("boxes:\n" + repeated("- {xyz: 1}\n", 20000)).size(), 10000U);
  EXPECT_LT(errorOf(std::string(1000000, 'k') + ": 1").size(), 10000U);
  try {
    load(repeated("# comment\n", 2000000));
    FAIL() << "nothing thrown";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("bytes"), std::string::npos) << error.what();
  }
  EXPECT_THROW(loadScene("/dev/zero"), std::runtime_error);
}

}  // namespace
}  // namespace mixed_palletizing::simulation
