#include "scene_sections.hpp"

namespace mixed_palletizing::simulation {
namespace {

/// The keys that a marker and a board share.
void readPrint(YamlSection& section, Marker& marker) {
  section.read("dictionary", marker.dictionary);
  section.read("side_m", marker.side_m);
  section.read("quiet_zone_m", marker.quiet_zone_m);
  section.read("inverted", marker.inverted);
  section.read("position_m", marker.position_m);
  section.readAngle("yaw", marker.yaw_rad);
  section.read("surface", marker.surface);
}

}  // namespace

void readMarker(YamlSection section, Marker& marker) {
  readPrint(section, marker);
  section.read("id", marker.id);
  section.finish();
}

void readBoard(YamlSection section, MarkerBoard& board) {
  readPrint(section, board.first);
  section.read("first_id", board.first.id);
  section.read("columns", board.columns);
  section.read("rows", board.rows);
  section.read("gap_m", board.gap_m);
  section.finish();
}

}  // namespace mixed_palletizing::simulation
