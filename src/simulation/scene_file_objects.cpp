#include <map>
#include <stdexcept>

#include "scene_sections.hpp"

namespace mixed_palletizing::simulation {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

/// position_m and rpy_deg, or the key `matrix` with four rows.
void readPose(YamlSection& section, const std::string& matrix, geometry::Pose& pose) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Vector3d rpy_deg = Eigen::Vector3d::Zero();
  section.read("position_m", position);
  section.read("rpy_deg", rpy_deg);
  pose = poseFromRollPitchYaw(position, kRadPerDeg * rpy_deg);
  if (!section.has(matrix)) return;
  if (section.has("position_m") || section.has("rpy_deg")) {
    section.add(matrix, "is given beside position_m or rpy_deg");
  }
  section.read(matrix, pose.matrix());
  if (pose.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    section.add(matrix, "its last row is not 0 0 0 1");
    pose = geometry::Pose::Identity();
  }
}

bool isLength(YamlSection& section, const std::string& key, double value) {
  const bool holds = value > 0.0 && value <= kMaxMeshExtent;
  if (!holds) section.add(key, "is not a length in (0, 20] m");
  return holds;
}

void readCylinder(YamlSection section, SceneObject& object) {
  double radius = 0.05;
  double height = 0.2;
  section.read("radius_m", radius);
  section.read("height_m", height);
  section.finish();
  const bool sane = isLength(section, "radius_m", radius) && isLength(section, "height_m", height);
  if (sane) object.mesh = std::make_shared<TriangleMesh>(cylinderMesh(radius, height));
}

void readCuboid(YamlSection section, SceneObject& object) {
  Eigen::Vector3d size(0.2, 0.2, 0.2);
  section.read("size_m", size);
  section.finish();
  for (const double side : size) {
    if (!isLength(section, "size_m", side)) return;
  }
  object.mesh = std::make_shared<TriangleMesh>(cuboidMesh(size));
}

/// Metres in a unit of the file's numbers.
double readUnit(YamlSection& section) {
  static const std::map<std::string, double> units = {
      {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"inch", 0.0254}};
  std::string unit = "m";
  double scale = 1.0;
  section.read("unit", unit);
  section.read("scale", scale);
  const auto known = units.find(unit);
  if (known == units.end()) section.add("unit", "'" + unit + "' is none of m, cm, mm, inch");
  const bool sane = scale >= 1e-6 && scale <= 1e6;
  if (!sane) section.add("scale", "is not in [1e-6, 1e6]");
  return known == units.end() || !sane ? 0.0 : known->second * scale;
}

void readMesh(YamlSection& section, SceneObject& object) {
  const std::string path = section.readPath("mesh");
  const double metres_per_unit = readUnit(section);
  bool recenter = false;
  section.read("recenter", recenter);
  if (path.empty() || metres_per_unit == 0.0) return;
  try {
    object.mesh = loadMesh(path, metres_per_unit, recenter);
  } catch (const std::runtime_error& error) {
    section.add("mesh", error.what());
  }
}

}  // namespace

void readSurface(YamlSection section, SceneSurface& surface) {
  section.read("name", surface.name);
  section.read("size_m", surface.size_m);
  section.read("thickness_m", surface.thickness_m);
  section.read("rgb", surface.rgb);
  surface.texture = section.readTexture("texture");
  readPose(section, "world_from_surface", surface.world_from_surface);
  section.finish();
}

void readObject(YamlSection section, SceneObject& object) {
  section.read("name", object.name);
  section.read("rgb", object.rgb);
  readPose(section, "world_from_object", object.world_from_object);
  int shapes = 0;
  for (const char* kind : {"mesh", "cylinder", "cuboid"}) {
    if (!section.has(kind)) continue;
    ++shapes;
    object.kind = kind;
  }
  if (shapes != 1) {
    section.add("mesh", "give one of mesh, cylinder and cuboid");
  } else if (object.kind == "cylinder") {
    readCylinder(section.section("cylinder"), object);
  } else if (object.kind == "cuboid") {
    readCuboid(section.section("cuboid"), object);
  }
  if (section.has("mesh")) readMesh(section, object);
  for (const char* kind : {"mesh", "cylinder", "cuboid"}) section.take(kind);
  section.finish();
}

}  // namespace mixed_palletizing::simulation
