// Mesh files: every format gives the same solid, bad ones are refused with a clear reason, scenes name file and line.
#include <cmath>

#include <mixed_palletizing/simulation/capture.hpp>
#include <mixed_palletizing/simulation/scene_file.hpp>

#include "small_scenes.hpp"
#include "temporary_folder.hpp"

namespace mixed_palletizing::simulation {
namespace {

const std::string kCrate = MIXED_PALLETIZING_SOURCE_DIR "/test/data/bottle_crate.ply";
const std::string kPallet = MIXED_PALLETIZING_SOURCE_DIR "/config/meshes/eur_pallet.stl";

/// A tetrahedron with its right angle at the origin and legs of 1, 2 and 3.
const std::vector<Eigen::Vector3d> kCorners = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
const std::vector<std::array<std::size_t, 3>> kFaces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string text(const Eigen::Vector3d& v) {
  std::ostringstream out;
  out << v.x() << " " << v.y() << " " << v.z();
  return out.str();
}

std::string stl(const std::vector<Eigen::Vector3d>& corners = kCorners) {
  std::string out = "solid t\n";
  for (const auto& face : kFaces) {
    out += "facet normal 0 0 0\nouter loop\n";
    for (const std::size_t corner : face) out += "vertex " + text(corners[corner]) + "\n";
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid t\n";
}

std::string obj() {
  std::string out;
  for (const Eigen::Vector3d& corner : kCorners) out += "v " + text(corner) + "\n";
  for (const auto& face : kFaces) {
    out += "f";
    for (const std::size_t corner : face) out += " " + std::to_string(corner + 1);
    out += "\n";
  }
  return out;
}

std::string ply() {
  std::string out =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Eigen::Vector3d& corner : kCorners) out += text(corner) + "\n";
  for (const auto& face : kFaces) {
    out += "3";
    for (const std::size_t corner : face) out += " " + std::to_string(corner);
    out += "\n";
  }
  return out;
}

/// In millimetres with z up, as CAD programs write it.
std::string dae() {
  std::string numbers;
  std::string indices;
  for (const Eigen::Vector3d& corner : kCorners) numbers += text(1000.0 * corner) + " ";
  for (const auto& face : kFaces) {
    for (const std::size_t corner : face) indices += std::to_string(corner) + " ";
  }
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="pa" count="12">)" +
         numbers + R"(</float_array><technique_common><accessor source="#pa" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>)" +
         indices + R"(</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s" name="s"><node id="n" name="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
}

class MeshFile : public TemporaryFolder {
 protected:
  void expectRefused(const std::string& file, const std::string& reason, double metres_per_unit = 1.0) const {
    try {
      loadMesh(path(file), metres_per_unit);
      ADD_FAILURE() << file << " was accepted";
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      EXPECT_EQ(what.find(path(file) + ": "), 0u) << what;
      EXPECT_NE(what.find(reason), std::string::npos) << what;
      EXPECT_EQ(what.find('\n'), std::string::npos) << what;
    }
  }
};

TEST_F(MeshFile, EveryFormatGivesTheSameSolid) {
  write("t.stl", stl());
  write("t.obj", obj());
  write("t.ply", ply());
  write("t.dae", dae());
  for (const char* name : {"t.stl", "t.obj", "t.ply", "t.dae"}) {
    SCOPED_TRACE(name);
    const auto mesh = loadMesh(path(name));
    EXPECT_EQ(mesh->triangles.size(), 4u);
    EXPECT_TRUE(extentOf(*mesh).low.isApproxToConstant(0.0, 1e-6)) << extentOf(*mesh).low.transpose();
    EXPECT_TRUE(extentOf(*mesh).high.isApprox(Eigen::Vector3d(1, 2, 3), 1e-6))
        << extentOf(*mesh).high.transpose();
    EXPECT_NEAR(windingNumber(*mesh, {0.1, 0.1, 0.1}), 1.0, 1e-6);
    EXPECT_NEAR(windingNumber(*mesh, {0.9, 1.9, 2.9}), 0.0, 1e-6);
  }
}

TEST_F(MeshFile, ScaleAndOriginAreTheCallers) {
  write("t.stl", stl());
  const auto mesh = loadMesh(path("t.stl"), 0.1, true);
  EXPECT_TRUE(extentOf(*mesh).low.isApprox(Eigen::Vector3d(-0.05, -0.1, 0.0), 1e-6));
  EXPECT_TRUE(extentOf(*mesh).high.isApprox(Eigen::Vector3d(0.05, 0.1, 0.3), 1e-6));
  EXPECT_THROW(loadMesh(path("t.stl"), 0.0), std::invalid_argument);
}

TEST_F(MeshFile, BadFilesAreRefused) {
  expectRefused("none.stl", "is no file");
  expectRefused("", "is no file");  // a folder
  write("empty.stl", "");
  expectRefused("empty.stl", "is empty");
  write("solid.stl", "solid nothing\nendsolid nothing\n");
  expectRefused("solid.stl", "");
  write("points.obj", "v 0 0 0\nv 1 0 0\n");
  expectRefused("points.obj", "");
  write("text.ply", "this is no mesh\n");
  expectRefused("text.ply", "is no mesh");
  write("t.xyz", "1 2 3\n");
  expectRefused("t.xyz", "is no mesh");
  std::vector<Eigen::Vector3d> corners = kCorners;
  for (Eigen::Vector3d& corner : corners) corner *= 1000.0;
  write("mm.stl", stl(corners));
  expectRefused("mm.stl", "3000 m long, at most 20 m is allowed: are its numbers millimetres (unit: mm)?");
  EXPECT_NO_THROW(loadMesh(path("mm.stl"), 0.001));
  write("t.stl", stl());
  expectRefused("t.stl", "at least 0.001 m is needed", 1e-6);
  std::string nan = ply();
  nan.replace(nan.find("0 0 3\n"), 6, "0 nan 3\n");
  write("nan.ply", nan);
  expectRefused("nan.ply", "a vertex that is no finite number");
}

TEST_F(MeshFile, DamagedFilesAreRefusedOrSound) {
  const std::string whole = read(kCrate);
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::srand(seed);
    std::string damaged = whole;
    for (int i = 0; i < 3; ++i) damaged.erase(static_cast<std::size_t>(std::rand()) % damaged.size(), 7);
    write("d.ply", damaged);
    try {
      const auto mesh = loadMesh(path("d.ply"));
      for (const auto& triangle : mesh->triangles) {
        for (const std::uint32_t corner : triangle) ASSERT_LT(corner, mesh->vertices.size());
      }
    } catch (const std::runtime_error&) {  // the only kind of error allowed
    }
  }
}

TEST_F(MeshFile, HugeFilesAreRefused) {
  std::string text =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2000001\nproperty list uchar int vertex_indices\nend_header\n";
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  text.append(reinterpret_cast<const char*>(corners), sizeof corners);
  std::string face(1, '\3');
  for (const std::int32_t corner : {0, 1, 2})
    face.append(reinterpret_cast<const char*>(&corner), sizeof corner);
  for (int i = 0; i < 2000001; ++i) text += face;
  write("huge.ply", text);
  expectRefused("huge.ply", "has 2000001 triangles, at most 2000000 are allowed");
}

TEST_F(MeshFile, ShippedMeshesHaveTheirSizes) {
  const Extent pallet = extentOf(*loadMesh(kPallet, 0.001));
  EXPECT_TRUE((pallet.high - pallet.low).isApprox(Eigen::Vector3d(1.2, 0.8, 0.144), 1e-6));
  const Extent crate = extentOf(*loadMesh(kCrate));
  EXPECT_TRUE((crate.high - crate.low).isApprox(Eigen::Vector3d(0.4, 0.3, 0.27), 1e-6));
}

TEST_F(MeshFile, ACrateInASceneIsOpenAtTheTop) {
  Scene scene = bareFloor(1.5);
  scene.objects.resize(1);
  scene.objects[0].mesh = loadMesh(kCrate);
  const Capture result = capture(scene, 1);
  const auto height = [&](double x, double y) {
    const Eigen::Vector3d image = scene.camera.world_from_camera.inverse() * Eigen::Vector3d(x, y, 0.01);
    const double f = 0.5 * 320 / std::tan(0.5 * scene.camera.horizontal_fov_rad);
    const auto row = static_cast<int>(std::lround(f * image.y() / image.z() + 99.5));
    const auto col = static_cast<int>(std::lround(f * image.x() / image.z() + 159.5));
    return worldPoint(scene, result.cloud.points[pixelIndex(scene, row, col)]).z();
  };
  EXPECT_NEAR(height(0.0, 0.035), 0.01, 1e-4);  // the bottom of a compartment
  EXPECT_GT(result.object_visible_pixels[0], 1000u);
}

const std::string kCamera = "camera: {eye_m: [0, 0, 2], target_m: [0, 0, 0]}\n";

TEST_F(MeshFile, ObjectsAndSurfacesOfASceneFileArrive) {
  write("t.stl", stl());
  const Scene scene = loadScene(write("s.yaml", kCamera + R"(
surfaces:
  - {name: table, size_m: [0.9, 0.8], thickness_m: 0.02, position_m: [1, 2, 0.3], rpy_deg: [0, 0, 90], rgb: 0x010203}
markers:
  - {id: 4, surface: table, position_m: [0.1, 0.2], yaw_deg: 90}
boards:
  - {dictionary: DICT_5X5_50, first_id: 3, columns: 2, rows: 1, side_m: 0.05, gap_m: 0.01, inverted: false}
objects:
  - {name: a, mesh: t.stl, unit: cm, scale: 2, recenter: true, position_m: [0.5, 0.6, 0.1], rgb: 0x040506}
  - {cylinder: {radius_m: 0.1, height_m: 0.3}, world_from_object: [[1, 0, 0, -0.5], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}
  - {cuboid: {size_m: [0.1, 0.2, 0.3]}, position_m: [0.2, 0, 0], rpy_deg: [90, 0, 0]}
)"));
  ASSERT_EQ(scene.surfaces.size(), 1u);
  EXPECT_EQ(scene.surfaces[0].name, "table");
  EXPECT_EQ(scene.surfaces[0].size_m, Eigen::Vector2d(0.9, 0.8));
  EXPECT_EQ(scene.surfaces[0].thickness_m, 0.02);
  EXPECT_EQ(scene.surfaces[0].rgb, 0x010203u);
  EXPECT_TRUE(
      (scene.surfaces[0].world_from_surface * Eigen::Vector3d::UnitX()).isApprox(Eigen::Vector3d(1, 3, 0.3)));
  ASSERT_EQ(scene.markers.size(), 1u);
  EXPECT_EQ(scene.markers[0].id, 4);
  EXPECT_EQ(scene.markers[0].surface, "table");
  ASSERT_EQ(scene.boards.size(), 1u);
  EXPECT_EQ(scene.boards[0].first.id, 3);
  EXPECT_EQ(scene.boards[0].first.dictionary, "DICT_5X5_50");
  EXPECT_EQ(scene.boards[0].columns, 2);
  EXPECT_EQ(scene.boards[0].rows, 1);
  EXPECT_EQ(scene.boards[0].gap_m, 0.01);
  ASSERT_EQ(scene.objects.size(), 3u);
  EXPECT_EQ(scene.objects[0].name, "a");
  EXPECT_EQ(scene.objects[0].kind, "mesh");
  EXPECT_EQ(scene.objects[0].rgb, 0x040506u);
  EXPECT_TRUE(extentOf(*scene.objects[0].mesh).high.isApprox(Eigen::Vector3d(0.01, 0.02, 0.06), 1e-6));
  EXPECT_EQ(scene.objects[1].kind, "cylinder");
  EXPECT_EQ(scene.objects[1].world_from_object.translation().x(), -0.5);
  EXPECT_EQ(scene.objects[2].kind, "cuboid");
  EXPECT_TRUE(
      (scene.objects[2].world_from_object * Eigen::Vector3d::UnitY()).isApprox(Eigen::Vector3d(0.2, 0, 1)));
}

TEST_F(MeshFile, MistakesInASceneFileAreNamed) {
  write("mm.stl", stl({{0, 0, 0}, {1000, 0, 0}, {0, 1000, 0}, {0, 0, 1000}}));
  const auto expectError = [&](const std::string& lines, int line, const std::string& mistake) {
    try {
      loadScene(write("s.yaml", kCamera + lines));
      ADD_FAILURE() << "accepted: " << lines;
    } catch (const std::invalid_argument& error) {
      const std::string expected = path("s.yaml") + ":" + std::to_string(line) + ": " + mistake;
      EXPECT_NE(std::string(error.what()).find(expected), std::string::npos)
          << "not '" << expected << "' but '" << error.what() << "'";
    }
  };
  expectError("objects:\n  - rgb: 1\n    mesh: none.stl\n", 4,
              "objects[0].mesh: " + path("none.stl") + ": is no file");
  expectError("objects:\n  - mesh: mm.stl\n", 3, "objects[0].mesh: " + path("mm.stl") + ": is 1000 m long");
  expectError("objects:\n  - {rgb: 1}\n", 3, "objects[0].mesh: give one of mesh, cylinder and cuboid");
  expectError("objects:\n  - {mesh: a, cuboid: {}}\n", 3, "objects[0].mesh: give one of");
  expectError("objects:\n  - mesh: mm.stl\n    unit: ell\n", 4, "objects[0].unit: 'ell' is none of");
  expectError("objects:\n  - mesh: mm.stl\n    scale: -1\n", 4, "objects[0].scale: is not in");
  expectError("objects:\n  - cylinder: {radius_m: 80}\n", 3, "objects[0].cylinder.radius_m: is not a length");
  expectError("objects:\n  - cuboid: {size_m: [1, 0, 1]}\n", 3, "objects[0].cuboid.size_m: is not a length");
  expectError("objects:\n  - cuboid: {}\n    unit: mm\n", 4, "objects[0].unit: is no known key");
  expectError("objects:\n  - cuboid: {}\n    position_m: [0, 0, 1.9]\n", 3, "objects[0]: holds the camera");
  expectError("surfaces:\n  - {name: t}\n  - {name: t}\n", 4, "surfaces[1].name: 't' is empty or another");
  expectError("surfaces:\n  - name: t\n    texture: none.png\n", 4,
              "surfaces[0].texture: " + path("none.png") + ": is no file");
  expectError("boxes:\n  - face_texture:\n      top: none.png\n", 4, "boxes[0].face_texture.top: ");
  expectError("markers:\n  - surface: chair\n", 3, "markers[0].surface: 'chair' is no surface");
  expectError("boards:\n  - {rows: 2, first_id: 60}\n", 3, "boards[0].first_id: 60 is not in");
}

}  // namespace
}  // namespace mixed_palletizing::simulation
