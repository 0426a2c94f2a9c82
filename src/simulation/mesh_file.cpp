#include <cmath>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <mixed_palletizing/simulation/triangle_mesh.hpp>

namespace mixed_palletizing::simulation {
namespace {

constexpr std::uintmax_t kMaxFileBytes = 1u << 30;

void checkFile(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) throw std::runtime_error(path + ": is no file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw std::runtime_error(path + ": cannot read: " + error.message());
  if (size == 0) throw std::runtime_error(path + ": is empty");
  if (size > kMaxFileBytes) {
    throw std::runtime_error(path + ": has " + std::to_string(size) + " bytes, at most 1 GiB is read");
  }
}

/// Appends what a part of the file has of triangles.
void append(const aiMesh& part, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& v = part.mVertices[i];
    mesh.vertices.emplace_back(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;  // points and lines
    mesh.triangles.push_back({first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]});
  }
}

TriangleMesh readTriangles(const std::string& path) {
  Assimp::Importer importer;
  // The file's axes are taken as they are: nothing is turned to have y up.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  // Validated first: the later steps trust the indices of a damaged file.
  const aiScene* scene =
      importer.ReadFile(path, aiProcess_ValidateDataStructure | aiProcess_Triangulate |
                                  aiProcess_JoinIdenticalVertices | aiProcess_PreTransformVertices);
  if (scene == nullptr) {
    std::string reason = importer.GetErrorString();
    for (char& c : reason) c = c == '\n' || c == '\r' ? ' ' : c;
    throw std::runtime_error(path + ": is no mesh: " + reason);
  }
  TriangleMesh mesh;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) append(*scene->mMeshes[i], mesh);
  return mesh;
}

[[noreturn]] void refuseExtent(const std::string& path, double extent) {
  std::ostringstream text;
  text << path << ": is " << extent << " m long, ";
  if (extent > kMaxMeshExtent) {
    text << "at most " << kMaxMeshExtent << " m is allowed: are its numbers millimetres (unit: mm)?";
  } else {
    text << "at least " << kMinMeshExtent << " m is needed: are its numbers metres (unit: m)?";
  }
  throw std::runtime_error(text.str());
}

void checkMesh(const std::string& path, const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) throw std::runtime_error(path + ": has no triangles");
  if (mesh.triangles.size() > kMaxMeshTriangles) {
    throw std::runtime_error(path + ": has " + std::to_string(mesh.triangles.size()) +
                             " triangles, at most " + std::to_string(kMaxMeshTriangles) + " are allowed");
  }
  for (const Eigen::Vector3d& vertex : mesh.vertices) {
    if (!vertex.allFinite()) throw std::runtime_error(path + ": has a vertex that is no finite number");
  }
  const Extent extent = extentOf(mesh);
  const double longest = (extent.high - extent.low).maxCoeff();
  if (longest > kMaxMeshExtent || longest < kMinMeshExtent) refuseExtent(path, longest);
}

}  // namespace

std::shared_ptr<const TriangleMesh> loadMesh(const std::string& path, double metres_per_unit, bool recenter) {
  if (!(metres_per_unit > 0.0) || !std::isfinite(metres_per_unit)) {
    throw std::invalid_argument("loadMesh: metres_per_unit = " + std::to_string(metres_per_unit) +
                                " is not > 0");
  }
  checkFile(path);
  auto mesh = std::make_shared<TriangleMesh>(readTriangles(path));
  for (Eigen::Vector3d& vertex : mesh->vertices) vertex *= metres_per_unit;
  checkMesh(path, *mesh);
  if (recenter) {
    const Extent extent = extentOf(*mesh);
    const Eigen::Vector2d middle = 0.5 * (extent.low + extent.high).head<2>();
    const Eigen::Vector3d origin(middle.x(), middle.y(), extent.low.z());
    for (Eigen::Vector3d& vertex : mesh->vertices) vertex -= origin;
  }
  return mesh;
}

}  // namespace mixed_palletizing::simulation
