#include <array>
#include <utility>

#include "scene_sections.hpp"

namespace mixed_palletizing::simulation {
namespace {

void readLabel(YamlSection section, BoxLabel& label) {
  section.read("center_m", label.center_m);
  section.read("size_m", label.size_m);
  section.read("rgb", label.rgb);
  section.read("down_sides", label.down_sides);
  section.finish();
}

using FaceNames = std::array<std::pair<const char*, BoxFace>, 6>;
constexpr FaceNames kFaces = {{{"minus_x", BoxFace::kMinusX},
                               {"plus_x", BoxFace::kPlusX},
                               {"minus_y", BoxFace::kMinusY},
                               {"plus_y", BoxFace::kPlusY},
                               {"bottom", BoxFace::kBottom},
                               {"top", BoxFace::kTop}}};

void readFaceColors(YamlSection section, SceneBox& box) {
  for (const auto& [name, face] : kFaces) {
    if (!section.has(name)) continue;
    std::uint32_t rgb = box.rgb;
    section.read(name, rgb);
    box.face_rgb[static_cast<std::size_t>(face)] = rgb;
  }
  section.finish();
}

void readFaceTextures(YamlSection section, SceneBox& box) {
  for (const auto& [name, face] : kFaces) {
    if (section.has(name)) box.face_texture[static_cast<std::size_t>(face)] = section.readTexture(name);
  }
  section.finish();
}

BoxFace readSide(YamlSection& section) {
  std::string text = "plus_x";
  section.read("side", text);
  for (const auto& [name, face] : kFaces) {
    if (text == name && face < BoxFace::kBottom) return face;
  }
  section.add("side", "'" + text + "' is none of minus_x, plus_x, minus_y, plus_y");
  return BoxFace::kPlusX;
}

void readShape(YamlSection section, BoxShape& shape) {
  section.read("bulge_m", shape.bulge_m);
  section.read("rounding_m", shape.rounding_m);
  for (YamlSection& entry : section.list("dents")) {
    BoxDent& dent = shape.dents.emplace_back();
    entry.read("center_m", dent.center_m);
    entry.read("radius_m", dent.radius_m);
    entry.read("depth_m", dent.depth_m);
    entry.finish();
  }
  for (YamlSection& entry : section.list("flaps")) {
    BoxFlap& flap = shape.flaps.emplace_back();
    flap.side = readSide(entry);
    entry.read("length_m", flap.length_m);
    entry.readAngle("angle", flap.angle_rad);
    entry.finish();
  }
  section.finish();
}

}  // namespace

void readBox(YamlSection section, SceneBox& box) {
  section.read("name", box.name);
  section.read("size_m", box.size_m);
  section.read("position_m", box.position_m);
  section.read("base_z_m", box.base_z_m);
  section.readAngle("yaw", box.yaw_rad);
  section.read("rgb", box.rgb);
  readFaceColors(section.section("face_rgb"), box);
  box.face_texture.fill(section.readTexture("texture"));
  readFaceTextures(section.section("face_texture"), box);
  for (YamlSection& label : section.list("labels")) readLabel(label, box.labels.emplace_back());
  readShape(section.section("shape"), box.shape);
  section.finish();
}

}  // namespace mixed_palletizing::simulation
