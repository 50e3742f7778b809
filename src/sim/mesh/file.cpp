#include "sim/mesh/file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/ieee.hpp"
#include "base/isolated.hpp"
#include "base/packed.hpp"
#include "sim/mesh/before_library.hpp"
#include "sim/mesh/builder.hpp"
#include "sim/mesh/gltf_file.hpp"
#include "sim/mesh/library_materials.hpp"
#include "sim/mesh/texture_place.hpp"

#include <algorithm>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cctype>
#include <stdexcept>
#include <string>

#include <glm/mat4x4.hpp>

namespace simreel::sim {

namespace {

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

glm::vec3 toVec(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

/// OBJ and PLY count v from the last row of a picture, we from the first.
glm::vec2 pictureUv(const aiVector3D& uv) {
  return {uv.x, 1.0F - uv.y};
}

/// Linear light of what pictures and scanners write, IEC 61966-2-1.
float linearOf(float encoded) {
  const double c = std::clamp(static_cast<double>(encoded), 0.0, 1.0);
  return static_cast<float>(c <= 0.04045 ? c / 12.92 : ieee::pow((c + 0.055) / 1.055, 2.4));
}

glm::mat4 toMat(const aiMatrix4x4& m) {
  return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

class Gatherer {
 public:
  Gatherer(const std::filesystem::path& file, const aiScene& scene)
      : file_(file), scene_(scene), builder_(file) {}

  /// With the materials of those libraries.
  Mesh gather(const std::vector<std::string>& libraries) {
    node(*scene_.mRootNode, glm::mat4(1), 0);
    Mesh mesh = builder_.finish();
    std::vector<std::string> names;
    for (unsigned i = 0; i < scene_.mNumMaterials; ++i)
      names.emplace_back(scene_.mMaterials[i]->GetName().C_Str());
    addLibraryMaterials(file_, libraries, names, mesh);
    placeTextures(mesh);
    if (fades_) mesh.ignored.emplace_back("the opacity of its vertices");
    return mesh;
  }

 private:
  void node(const aiNode& here, const glm::mat4& parent, int depth) {
    if (depth > maxNodeDepth) refuseMesh(file_, "nests its nodes too deeply");
    const glm::mat4 transform = parent * toMat(here.mTransformation);
    for (unsigned i = 0; i < here.mNumMeshes; ++i) {
      if (here.mMeshes[i] >= scene_.mNumMeshes) refuseMesh(file_, "names a mesh that it does not hold");
      add(*scene_.mMeshes[here.mMeshes[i]], transform);
    }
    for (unsigned i = 0; i < here.mNumChildren; ++i) node(*here.mChildren[i], transform, depth + 1);
  }

  void add(const aiMesh& part, const glm::mat4& transform) {
    if ((part.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) == 0) return;
    const bool textured = part.HasTextureCoords(0);
    builder_.begin(part.mNumVertices, part.mNumFaces, transform, textured,
                   static_cast<int>(part.mMaterialIndex));
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const glm::vec3 position = toVec(part.mVertices[i]);
      const glm::vec3 normal = part.HasNormals() ? toVec(part.mNormals[i]) : glm::vec3(0);
      const glm::vec2 uv = textured ? pictureUv(part.mTextureCoords[0][i]) : glm::vec2(0);
      if (!part.HasVertexColors(0)) {
        builder_.vertex(position, normal, uv);
        continue;
      }
      const aiColor4D& color = part.mColors[0][i];
      builder_.vertex(position, normal, uv, {linearOf(color.r), linearOf(color.g), linearOf(color.b)});
      fades_ = fades_ || color.a < 1;
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices == 3) builder_.triangle({face.mIndices[0], face.mIndices[1], face.mIndices[2]});
    }
  }

  const std::filesystem::path& file_;
  const aiScene& scene_;
  MeshBuilder builder_;
  bool fades_ = false;
};

/// The library's own steps take for granted, some by assertion, what broken files do not keep.
void checkBeforeProcessing(const std::filesystem::path& file, const aiScene& scene) {
  if (scene.mNumMeshes == 0) refuseMesh(file, "holds no triangle");
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    if (part.mNumFaces == 0 || part.mNumVertices == 0 || part.mVertices == nullptr)
      refuseMesh(file, "has a part without faces");
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices == 0) refuseMesh(file, fmt::format("has a face without corners (number {})", i));
      if (face.mNumIndices > maxCorners)
        refuseMesh(file, fmt::format("has a face of {} corners (number {}), more than {}; cut it up",
                                     face.mNumIndices, i, maxCorners));
      for (unsigned k = 0; k < face.mNumIndices; ++k)
        if (face.mIndices[k] >= part.mNumVertices)
          refuseMesh(file,
                     fmt::format("has a face with vertex {} of {}", face.mIndices[k], part.mNumVertices));
    }
  }
}

/// Opens the mesh alone: materials of OBJ we read ourselves (library_materials.hpp), and the library would
/// refuse the mesh for words of theirs that it does not know. Notes what lies outside its folder, links
/// followed.
class MeshAlone : public Assimp::DefaultIOSystem {
 public:
  explicit MeshAlone(const std::filesystem::path& file) : file_(file) {}

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    return allowed(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
  }
  bool Exists(const char* name) const override { return allowed(name) && DefaultIOSystem::Exists(name); }
  /// The first name that was refused; empty when none was.
  [[nodiscard]] const std::string& refused() const { return refused_; }

 private:
  bool allowed(const char* name) const {
    if (file_ == name) return true;
    if (!liesBeside(file_, name) && refused_.empty()) refused_ = name;
    return false;
  }
  const std::filesystem::path& file_;
  mutable std::string refused_;
};

Mesh readWithLibrary(const std::filesystem::path& file, const std::vector<std::string>& libraries) {
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  auto* const io = new MeshAlone(file);  // the importer's own from here
  importer.SetIOHandler(io);
  const aiScene* scene = importer.ReadFile(file.string(), 0);
  if (!io->refused().empty())
    refuseMesh(file, fmt::format("names {}, which lies outside its folder", io->refused()));
  if (scene == nullptr || scene->mRootNode == nullptr) {
    std::string why = importer.GetErrorString();
    why = why.substr(0, why.find('\n'));
    refuseMesh(file, fmt::format("cannot be read ({})", why.empty() ? "unknown reason" : why));
  }
  checkBeforeProcessing(file, *scene);
  scene = importer.ApplyPostProcessing(aiProcess_Triangulate | aiProcess_SortByPType |
                                       aiProcess_JoinIdenticalVertices);
  if (scene == nullptr || scene->mRootNode == nullptr) refuseMesh(file, "cannot be divided into triangles");
  return Gatherer(file, *scene).gather(libraries);
}

}  // namespace

bool isGltf(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  return extension == ".gltf" || extension == ".glb";
}

Mesh importMesh(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  if (extension != ".obj" && extension != ".ply" && !isGltf(file))
    fail(ExitCode::usage, "the mesh {} is none of .obj, .ply, .gltf and .glb", file.string());
  const std::string text = readFile(file, "mesh");  // says why a file cannot be read, or is too large
  if (isGltf(file)) return readGltf(file, text);
  if (extension == ".ply") checkPly(file, text);
  if (extension == ".obj") checkObj(file, text);
  return readWithLibrary(file, extension == ".obj" ? librariesOf(text) : std::vector<std::string>());
}

std::string readApart(const std::filesystem::path& file, const std::function<std::string()>& read) {
  std::error_code unknown;
  const auto size = std::filesystem::file_size(file, unknown);
  const std::size_t bytes = unknown ? 0 : size;
  // What the library makes of a byte has been seen to take 30, what we make of glTF is counted beforehand.
  const Allotment allotment{isGltf(file) ? std::size_t{4} << 30 : (std::size_t{256} << 20) + 64 * bytes,
                            10 + static_cast<int>(std::min<std::size_t>(bytes >> 20U, 3600))};
  try {
    return runIsolated(allotment, read);
  } catch (const UserError&) {
    throw;
  } catch (const std::runtime_error& end) {
    refuseMesh(file, fmt::format("cannot be read: the reader {}", end.what()));
  }
}

Mesh loadMesh(const std::filesystem::path& file) {
  return unpacked<Mesh>(readApart(file, [&] { return packed(importMesh(file)); }));
}

}  // namespace simreel::sim
