// Many scenes of a recipe, with their truth.
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>

#include <mixed_palletizing/adapters/captures/dataset.hpp>
#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/adapters/progress_line.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace captures = mixed_palletizing::captures;

int main(int argc, char** argv) {
  captures::DatasetOptions options;
  std::string layout = "default";
  bool quiet = false;
  adapters::CommandLine line(
      "simulate_dataset",
      "Scenes of a recipe as a camera sees them, with truth, images and masks. Continues a "
      "folder that is not complete.");
  line.required("recipe", &options.recipe, "recipe file (docs/datasets.md)");
  line.required("count", &options.count, "scenes");
  line.required("out", &options.out, "folder of the data set");
  line.option("seed", &options.seed, "of every random choice");
  line.choice("cloud", &options.cloud, {"pcd", "ply"}, "kind of cloud files");
  line.option("layout", &layout, "fields of a point: " + adapters::cloudLayoutHelp());
  line.flag("bag", &options.bag, "also a bag for each scene, as recorded from the driver");
  line.option("threads", &options.threads, "scenes made at a time; the result does not depend on it");
  line.flag("quiet", &quiet, "no progress bar and no summary");
  return line.run(argc, argv, [&] {
    options.layout = adapters::optionalCloudLayout(layout);
    std::optional<adapters::ProgressLine> progress;
    const captures::DatasetResult result = captures::writeDataset(options, [&](int done, int total) {
      if (quiet) return;
      const auto number = static_cast<std::uint64_t>(done);
      progress ? progress->step()
               : void(progress.emplace(static_cast<std::uint64_t>(total), "scenes", number));
    });
    progress.reset();
    if (!quiet) {
      std::cout << options.out << ": " << options.count << " scenes, " << result.written
                << " of them written now\n";
    }
    return 0;
  });
}
