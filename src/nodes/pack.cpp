// Packs the orders of a file, the sequence free to choose.
#include <fstream>
#include <iostream>
#include <optional>
#include <stdexcept>

#include <mixed_palletizing/adapters/order_files.hpp>
#include <mixed_palletizing/adapters/progress_line.hpp>
#include <mixed_palletizing/instances/pack_instance.hpp>

namespace instances = mixed_palletizing::instances;
namespace packing = mixed_palletizing::packing;

int main(int argc, char** argv) {
  mixed_palletizing::adapters::OrderFileOptions orders;
  instances::PackRun run;
  run.method = "best";
  std::string out;
  std::string spaces = "supported";
  bool keep_going = false;
  bool progress = false;
  bool quiet = false;
  mixed_palletizing::adapters::CommandLine line("pack",
                                                "Packs every order of a file, the sequence free to choose "
                                                "(dblf, distance, contact, best_fit: in the given order).");
  orders.declare(line);
  line.required("out", &out, "file to write, one JSON object a line");
  line.choice("method", &run.method, packing::packMethodWords(), "best = the strongest search there is");
  line.option("time_limit_s", &run.time_limit_s, "of the searches, for one order [s]; 0 = none");
  line.option(
      "max_evaluations", &run.max_evaluations,
      "of the searches, for one order; 0 = no limit. With --time_limit_s 0 the result is reproducible");
  line.option("max_pallets", &run.max_pallets,
              "for one order; 0 = as many as it needs, which is the default for csv and bed_bpp");
  line.choice("spaces", &spaces, {"supported", "empty"},
              "maximal spaces that offer places; all rules hold in both");
  line.option("seed", &run.options.seed, "of every random choice");
  line.option("threads", &run.options.threads,
              "1 or 2, of brkga and best; --max_evaluations counts for each");
  line.flag("keep-going", &keep_going, "pack the sound orders of a file that has faults");
  line.flag("progress", &progress, "one line an order on stderr");
  line.flag("quiet", &quiet, "no progress bar");
  return line.run(argc, argv, [&] {
    run.options.method = *packing::packMethodFromString(run.method);
    if (spaces == "empty") run.options.spaces = packing::SpaceKind::kEmpty;
    const bool published =
        orders.format() == instances::OrderFormat::kCsv || orders.format() == instances::OrderFormat::kBedBpp;
    if (published && !line.given("max_pallets")) run.max_pallets = 0;
    const std::vector<std::string> broken = instances::problems(run);
    if (!broken.empty()) throw std::invalid_argument(instances::joinFaults(broken));
    const instances::InstanceFile file = orders.readSound("pack", keep_going);
    std::ofstream results(out);
    instances::PackSummary summary;
    std::optional<mixed_palletizing::adapters::ProgressLine> bar;
    if (!progress && !quiet) bar.emplace(file.instances.size(), "orders");
    for (const instances::Instance& instance : file.instances) {
      const instances::PackingResult result = instances::packInstance(instance, run);
      results << instances::formatResult(result, instance) << std::endl;
      if (!results) break;
      summary.add(instance, result);
      if (bar) bar->step();
      if (progress) {
        std::cerr << result.name << ": " << result.pallets << " pallets, " << 100.0 * result.utilization
                  << " %, " << result.unpacked.size() << " unpacked, " << result.decision_ms.max_ms << " ms"
                  << std::endl;
      }
    }
    bar.reset();
    results.close();
    if (!results) throw std::runtime_error(out + ": cannot be written");
    std::cout << summary.text() << '\n';
    return file.faults.empty() ? 0 : 1;
  });
}
