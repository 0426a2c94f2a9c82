// Shows and exports what the journal of a planner holds.
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include <mixed_palletizing/adapters/command_line.hpp>
#include <mixed_palletizing/planning/journal_export.hpp>

namespace planning = mixed_palletizing::planning;

int main(int argc, char** argv) {
  std::string path, pallet, json;
  bool list = false;
  mixed_palletizing::adapters::CommandLine line(
      "pallet_journal",
      "Prints the history of a pallet from a planner's journal; also while the planner runs.");
  line.required("journal", &path, "file, by default ~/.ros/mixed_palletizing/pick_planner.journal");
  line.option("pallet", &pallet, "id; empty = the last one");
  line.option("json", &json, "file for the pallet as a JSON object");
  line.flag("list", &list, "list the pallets instead");
  return line.run(argc, argv, [&] {
    const auto entries = planning::readJournal(path);
    if (list) {
      std::cout << planning::palletList(entries);
      return 0;
    }
    const auto mine = planning::entriesOf(entries, pallet);
    std::cout << planning::palletHistory(mine);
    if (json.empty()) return 0;
    std::ofstream file(json);
    file << planning::palletJson(mine) << '\n';
    if (!file) throw std::runtime_error(json + ": cannot be written");
    return 0;
  });
}
