// One cloud of a scene file, with its truth.
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <string>

#include <mixed_palletizing/adapters/cloud_files.hpp>
#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/scene_file.hpp>
#include <mixed_palletizing/simulation/truth_files.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace simulation = mixed_palletizing::simulation;

int main(int argc, char** argv) {
  std::string scene_path;
  std::string out;
  std::string truth;
  std::string mask;
  std::uint64_t seed = 1;
  int threads = 2;
  adapters::CommandLine line("simulate_scene", "One cloud of a scene as its camera sees it, with its truth.");
  line.required("scene", &scene_path, "scene file (docs/scene_files.md)");
  line.required("out", &out, "cloud to write, .pcd or .ply");
  line.required("truth", &truth, "JSON to write: camera, boxes, what can be seen of them");
  line.option("mask", &mask,
              "16-bit PNG to write: 0 = no box and no object, i + 1 = box i of the scene, then its objects");
  line.option("seed", &seed, "of the sensor's noise");
  line.option("threads", &threads, "for the ray casting; the result does not depend on it");
  return line.run(argc, argv, [&] {
    const simulation::Scene scene = simulation::loadScene(scene_path);
    for (const std::string& warning : simulation::warnings(scene)) {
      std::cerr << scene_path << ": warning: " << warning << "\n";
    }
    const simulation::Capture capture = simulation::capture(scene, seed, threads);
    adapters::writeCloud(out, capture.cloud);
    simulation::writeTruth(truth, scene, capture, seed);
    if (line.given("mask")) simulation::writeMask(mask, capture);
    const auto points = std::count_if(capture.cloud.points.begin(), capture.cloud.points.end(),
                                      [](const auto& point) { return point.z > 0.0f; });
    std::cout << out << ": " << capture.cloud.width << " x " << capture.cloud.height << ", " << points
              << " points with data, " << scene.boxes.size() << " boxes, " << scene.objects.size()
              << " objects\n";
    return 0;
  });
}
