// One cloud of a scene file, with its truth.
#include <algorithm>
#include <cstdint>
#include <iostream>
#include <string>

#include <mixed_palletizing/adapters/captures/capture_files.hpp>
#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/scene_file.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace captures = mixed_palletizing::captures;
namespace simulation = mixed_palletizing::simulation;

int main(int argc, char** argv) {
  std::string scene_path;
  captures::CaptureFiles files;
  std::string layout = "default";
  std::uint64_t seed = 1;
  int threads = 2;
  adapters::CommandLine line("simulate_scene", "One cloud of a scene as its camera sees it, with its truth.");
  line.required("scene", &scene_path, "scene file (docs/scene_files.md)");
  line.required("out", &files.cloud, "cloud to write, .pcd or .ply");
  line.required("truth", &files.truth, "JSON to write: camera, boxes, what can be seen of them");
  line.option("mask", &files.mask,
              "16-bit PNG to write: 0 = no box and no object, i + 1 = box i of the scene, then its objects");
  line.option("color", &files.color, "PNG to write: colour image");
  line.option("depth", &files.depth, "TIFF to write: z [m] as float32, NaN without data");
  line.option("camera_info", &files.camera_info, "YAML to write: the camera's calibration");
  line.option("bag", &files.bag,
              "bag to write: cloud, images and camera_info as recorded from the driver, and tf");
  line.option("layout", &layout, "fields of a point: " + adapters::cloudLayoutHelp());
  line.option("seed", &seed, "of the sensor's noise");
  line.option("threads", &threads, "for the ray casting; the result does not depend on it");
  return line.run(argc, argv, [&] {
    files.layout = adapters::optionalCloudLayout(layout);
    const simulation::Scene scene = simulation::loadScene(scene_path);
    for (const std::string& warning : simulation::warnings(scene)) {
      std::cerr << scene_path << ": warning: " << warning << "\n";
    }
    const simulation::Capture capture = simulation::capture(scene, seed, threads);
    captures::writeCaptureFiles(files, scene, capture, seed);
    const auto points = std::count_if(capture.cloud.points.begin(), capture.cloud.points.end(),
                                      [](const auto& point) { return point.z > 0.0f; });
    std::cout << files.cloud << ": " << capture.cloud.width << " x " << capture.cloud.height << ", " << points
              << " points with data, " << scene.boxes.size() << " boxes, " << scene.objects.size()
              << " objects\n";
    return 0;
  });
}
