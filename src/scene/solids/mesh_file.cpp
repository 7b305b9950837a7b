#include "scene/solids/mesh_file.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <span>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

// The ray caster's tree needs a few hundred bytes per triangle.
constexpr std::size_t most_triangles = 5'000'000;
constexpr double largest_m = 100.0;

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  if (!ending.empty()) ending.erase(0, 1);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  // Assimp also reads PLY, but never returns on some damaged files.
  constexpr std::array<std::string_view, 2> known{"obj", "stl"};
  if (std::find(known.begin(), known.end(), ending) == known.end())
    throw Error(printable(file), "not a supported mesh file", "use an .obj or .stl file");
  return ending;
}

const aiScene* import_with(Assimp::Importer& importer, const std::vector<std::byte>& bytes,
                           const std::string& ending) {
  // Only positions and triangles are needed. Without normals, corners at one position are joined, so that a
  // solid is closed.
  importer.SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS | aiComponent_TEXCOORDS |
                                                          aiComponent_COLORS | aiComponent_MATERIALS |
                                                          aiComponent_TANGENTS_AND_BITANGENTS);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer.SetPropertyBool(AI_CONFIG_PP_FD_REMOVE, true);
  // Validation comes first: the other steps rely on valid data, and crash on a truncated file.
  return importer.ReadFileFromMemory(bytes.data(), bytes.size(),
                                     aiProcess_ValidateDataStructure | aiProcess_RemoveComponent |
                                         aiProcess_Triangulate | aiProcess_FindDegenerates |
                                         aiProcess_SortByPType | aiProcess_JoinIdenticalVertices |
                                         aiProcess_PreTransformVertices,
                                     ending.c_str());
}

TriangleMesh converted(const aiMesh& source, double unit_m) {
  TriangleMesh mesh;
  for (const aiVector3D& vertex : std::span(source.mVertices, source.mNumVertices))
    mesh.vertices.push_back((Eigen::Vector3d(vertex.x, vertex.y, vertex.z) * unit_m).cast<float>());
  for (const aiFace& face : std::span(source.mFaces, source.mNumFaces))
    if (face.mNumIndices == 3)
      mesh.triangles.push_back({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
  return mesh;
}

void require_sensible(const TriangleMesh& mesh, const std::filesystem::path& file) {
  if (mesh.triangles.empty()) throw Error(printable(file), "contains no triangles", "export it again");
  if (mesh.triangles.size() > most_triangles)
    throw Error(printable(file), "contains more than 5 million triangles", "export a coarser mesh");
  const bool fits =
      std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const Eigen::Vector3f& vertex) {
        return vertex.allFinite() && vertex.cwiseAbs().maxCoeff() < static_cast<float>(largest_m);
      });
  if (!fits)
    throw Error(printable(file), "extends beyond 100 m, or has coordinates that are not finite",
                "check its unit, or export it again");
}

}  // namespace

TriangleMesh load_mesh(const std::filesystem::path& file, double unit_m) {
  const std::string ending = ending_of(file);
  const std::vector<std::byte> bytes = read_file(file);
  Assimp::Importer importer;
  const aiScene* const imported = import_with(importer, bytes, ending);
  TriangleMesh mesh;
  if (imported != nullptr) {
    for (const aiMesh* part : std::span(imported->mMeshes, imported->mNumMeshes))
      mesh.append(converted(*part, unit_m));
  }
  require_sensible(mesh, file);
  if (is_closed(mesh) && volume_m3(mesh) < 0)
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  return mesh;
}

}  // namespace rva
