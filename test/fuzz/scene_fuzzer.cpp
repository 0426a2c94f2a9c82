// Scene files: any bytes give a scene or one of the two documented errors.
#include <stdexcept>

#include <mixed_palletizing/simulation/scene_file.hpp>

#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const mixed_palletizing::fuzz::ScratchFolder folder;
  const std::string path = folder.write("scene.yaml", data, size);
  try {
    mixed_palletizing::simulation::loadScene(path);
  } catch (const std::invalid_argument&) {
  } catch (const std::runtime_error&) {
  }
  return 0;
}
