// The variants of the thesis' chain against the truth of simulated scenes.
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/adapters/progress_line.hpp>
#include <mixed_palletizing/experiments/top_measurement.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace detection = mixed_palletizing::detection;
namespace experiments = mixed_palletizing::experiments;
namespace simulation = mixed_palletizing::simulation;

namespace {

struct Arguments {
  std::string recipe;
  std::uint64_t count = 20;
  std::uint64_t seed = 1;
  std::vector<double> thresholds_mm{1.0, 2.0, 5.0, 10.0, 20.0};
  std::string out;
};

int run(const Arguments& arguments) {
  std::vector<double> thresholds_m;
  for (const double threshold : arguments.thresholds_mm) {
    if (!(threshold > 0.0)) throw std::invalid_argument("--thresholds-mm: every threshold must be positive");
    thresholds_m.push_back(0.001 * threshold);
  }
  detection::DetectionOptions options;
  options.method = detection::Method::kThesis;
  const experiments::SceneSource source =
      experiments::recipeSource(simulation::loadRecipe(arguments.recipe), arguments.seed);
  std::ofstream file(arguments.out);
  std::size_t tops = 0;
  adapters::ProgressLine progress(arguments.count, "scenes");
  for (std::uint64_t scene = 0; scene < arguments.count; ++scene, progress.step()) {
    for (const auto& record : experiments::measureTops(source, scene, options, thresholds_m)) {
      file << experiments::topJson(record) << '\n';
      ++tops;
    }
  }
  file.close();
  if (!file) throw std::runtime_error(arguments.out + ": cannot be written");
  std::cout << tops << " tops in " << arguments.count << " scenes\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  adapters::CommandLine line("measure_tops",
                             "Separation of tops and formulas for sizes of the thesis, against the truth.");
  line.required("recipe", &arguments.recipe, "kind of scenes, a YAML file as in config/recipes");
  line.option("count", &arguments.count, "scenes");
  line.option("seed", &arguments.seed, "of scenes and noise");
  line.option("thresholds-mm", &arguments.thresholds_mm,
              "constant distances from the height, beside the adaptive one");
  line.required("out", &arguments.out, "file to write, one JSON object a top");
  return line.run(argc, argv, [&] { return run(arguments); });
}
