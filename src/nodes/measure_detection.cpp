// Detection against the truth of simulated scenes.
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/adapters/detector_options.hpp>
#include <mixed_palletizing/adapters/option_reader.hpp>
#include <mixed_palletizing/adapters/progress_line.hpp>
#include <mixed_palletizing/experiments/cloud_picture.hpp>
#include <mixed_palletizing/experiments/record_json.hpp>
#include <mixed_palletizing/simulation/recipe.hpp>

namespace adapters = mixed_palletizing::adapters;
namespace experiments = mixed_palletizing::experiments;
namespace detection = mixed_palletizing::detection;
namespace simulation = mixed_palletizing::simulation;

namespace {

struct Arguments {
  std::string recipe;
  std::uint64_t count = 20;
  std::uint64_t first = 0;
  std::uint64_t seed = 1;
  std::string method = "best";
  bool method_given = false;
  std::string base = "marker";
  std::string params;
  int threads = 1;
  std::string out;
  std::string summary;
  std::string picture;
};

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path + ": cannot be written");
}

int run(const Arguments& arguments) {
  experiments::MeasurementOptions options;
  if (!arguments.params.empty()) {
    options.detection = adapters::readDetectorOptions(adapters::loadYaml(arguments.params)).detection;
  }
  if (arguments.method_given || arguments.params.empty()) {
    const bool best = arguments.method == "best";
    options.detection.method = best ? detection::Method::kBest : detection::Method::kThesis;
  }
  if (arguments.base == "truth") options.base = experiments::BaseSource::kTruth;
  const simulation::Recipe recipe = simulation::loadRecipe(arguments.recipe);
  const experiments::SceneSource source = experiments::recipeSource(recipe, arguments.seed);
  if (!arguments.picture.empty()) {
    const auto capture = simulation::capture(source.scene(arguments.first),
                                             source.noise_seed(arguments.first), arguments.threads);
    experiments::writePicture(arguments.picture, capture.cloud);
  }
  adapters::ProgressLine progress(arguments.count, "scenes");
  const auto records = experiments::measureScenes(source, arguments.first, arguments.count, options,
                                                  arguments.threads, [&] { progress.step(); });
  std::string lines;
  for (const auto& record : records) lines += experiments::recordJson(record) + "\n";
  write(arguments.out, lines);
  const experiments::DetectionSummary summary = experiments::summarize(records);
  if (!arguments.summary.empty()) write(arguments.summary, experiments::summaryJson(summary) + "\n");
  std::printf("%s\n", experiments::summaryText(summary).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  adapters::CommandLine line("measure_detection",
                             "Detects in simulated scenes and compares with their truth.");
  line.required("recipe", &arguments.recipe, "kind of scenes, a YAML file as in config/recipes");
  line.option("count", &arguments.count, "scenes");
  line.option("first", &arguments.first, "index of the first scene");
  line.option("seed", &arguments.seed, "of scenes and noise");
  line.choice("method", &arguments.method, {"best", "thesis"}, "or else what the parameter file says");
  line.choice("base", &arguments.base, {"marker", "truth"},
              "base frame: found in each cloud, or the true one");
  line.option("params", &arguments.params, "parameter file of the detector node");
  line.option("threads", &arguments.threads, "scenes side by side; times are clean with 1");
  line.required("out", &arguments.out, "file to write, one JSON object a scene");
  line.option("summary", &arguments.summary, "file to write: the summary as one JSON object");
  line.option("picture", &arguments.picture, "file to write: the first scene's colours, .png or .jpg");
  return line.run(argc, argv, [&] {
    arguments.method_given = line.given("method");
    return run(arguments);
  });
}
