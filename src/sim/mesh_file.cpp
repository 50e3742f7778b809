#include "sim/mesh_file.hpp"

#include "base/error.hpp"
#include "base/file.hpp"

#include <algorithm>
#include <assimp/DefaultIOSystem.h>
#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

namespace simreel::sim {

namespace {

constexpr std::size_t mostItems = 8'000'000;
constexpr int mostDepth = 256;

std::string extensionOf(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& why) {
  fail(ExitCode::inputOutput, "the mesh {} {}", file.string(), why);
}

glm::vec3 toVec(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

class Gatherer {
 public:
  Gatherer(const std::filesystem::path& file, const aiScene& scene) : file_(file), scene_(scene) {}

  Mesh gather() {
    node(*scene_.mRootNode, aiMatrix4x4(), 0);
    if (mesh_.indices.empty()) refuse(file_, "holds no triangle");
    if (!hasUvs_) mesh_.uvs.clear();
    fillNormals();
    return std::move(mesh_);
  }

 private:
  void node(const aiNode& here, const aiMatrix4x4& parent, int depth) {
    if (depth > mostDepth) refuse(file_, "nests its nodes too deeply");
    const aiMatrix4x4 transform = parent * here.mTransformation;
    for (unsigned i = 0; i < here.mNumMeshes; ++i) {
      if (here.mMeshes[i] >= scene_.mNumMeshes) refuse(file_, "names a mesh that it does not hold");
      add(*scene_.mMeshes[here.mMeshes[i]], transform);
    }
    for (unsigned i = 0; i < here.mNumChildren; ++i) node(*here.mChildren[i], transform, depth + 1);
  }

  void add(const aiMesh& part, const aiMatrix4x4& transform) {
    if ((part.mPrimitiveTypes & aiPrimitiveType_TRIANGLE) == 0) return;
    const auto first = static_cast<unsigned>(mesh_.positions.size());
    if (first + std::size_t{part.mNumVertices} > mostItems ||
        mesh_.indices.size() / 3 + part.mNumFaces > mostItems)
      refuse(file_, fmt::format("has more than {} vertices or triangles; simplify it", mostItems));
    aiMatrix3x3 turn(transform);
    const bool mirrored = turn.Determinant() < 0;
    turn.Inverse().Transpose();
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      const glm::vec3 p = toVec(transform * part.mVertices[i]);
      if (!(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1e9F))
        refuse(file_,
               fmt::format("has a vertex that is not finite or farther than 1e9 m (number {})", first + i));
      mesh_.positions.push_back(p);
      const glm::vec3 n = part.HasNormals() ? toVec(turn * part.mNormals[i]) : glm::vec3(0);
      const float length = glm::length(n);
      mesh_.normals.push_back(length > 1e-20F && length < 1e20F ? n / length : glm::vec3(0));
      const bool textured = part.HasTextureCoords(0);
      hasUvs_ = hasUvs_ || textured;
      mesh_.uvs.push_back(textured ? glm::vec2(toVec(part.mTextureCoords[0][i])) : glm::vec2(0));
    }
    for (unsigned i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices != 3) continue;
      for (const unsigned k : {0U, mirrored ? 2U : 1U, mirrored ? 1U : 2U}) {
        if (face.mIndices[k] >= part.mNumVertices)
          refuse(file_,
                 fmt::format("has a triangle with vertex {} of {}", face.mIndices[k], part.mNumVertices));
        mesh_.indices.push_back(first + face.mIndices[k]);
      }
    }
  }

  /// Where there is no normal: the sum of the triangles' normals around the vertex, weighted by area.
  void fillNormals() {
    std::vector<glm::vec3> sums(mesh_.positions.size(), glm::vec3(0));
    for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) {
      const glm::vec3& a = mesh_.positions[mesh_.indices[i]];
      const glm::vec3 normal =
          glm::cross(mesh_.positions[mesh_.indices[i + 1]] - a, mesh_.positions[mesh_.indices[i + 2]] - a);
      for (std::size_t k = 0; k < 3; ++k) sums[mesh_.indices[i + k]] += normal;
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      if (mesh_.normals[i] != glm::vec3(0)) continue;
      const float length = glm::length(sums[i]);
      mesh_.normals[i] = length > 0 && std::isfinite(length) ? sums[i] / length : glm::vec3(0, 1, 0);
    }
  }

  const std::filesystem::path& file_;
  const aiScene& scene_;
  Mesh mesh_;
  bool hasUvs_ = false;
};

/// Opens nothing beside the mesh that lies outside its folder (buffers of glTF, materials of OBJ), links
/// followed.
class FolderOnly : public Assimp::DefaultIOSystem {
 public:
  explicit FolderOnly(const std::filesystem::path& file)
      : file_(file.string()),
        folder_(std::filesystem::weakly_canonical(std::filesystem::absolute(file).parent_path())) {}

  Assimp::IOStream* Open(const char* name, const char* mode) override {
    return allowed(name) ? DefaultIOSystem::Open(name, mode) : nullptr;
  }
  bool Exists(const char* name) const override { return allowed(name) && DefaultIOSystem::Exists(name); }
  /// The first name that was refused; empty when none was.
  [[nodiscard]] const std::string& refused() const { return refused_; }

 private:
  bool allowed(const char* name) const {
    if (file_ == name) return true;
    std::error_code error;
    const auto path = std::filesystem::weakly_canonical(std::filesystem::absolute(name, error), error);
    const std::string inside = path.lexically_relative(folder_).string();
    const bool good = !error && !inside.empty() && inside.rfind("..", 0) != 0;
    if (!good && refused_.empty()) refused_ = name;
    return good;
  }
  std::string file_;
  std::filesystem::path folder_;
  mutable std::string refused_;
};

/// The library believes counts before it looks for what they count.
void checkPlyCounts(const std::filesystem::path& file, std::string_view text) {
  std::string_view head = text.substr(0, std::min(text.find("end_header"), std::size_t{1} << 20U));
  for (std::size_t at = head.find("element "); at != std::string_view::npos;
       at = head.find("element ", at + 8)) {
    const std::size_t digits = head.find_first_of("0123456789", at);
    if (digits == std::string_view::npos) return;
    std::uint64_t count = 0;
    std::from_chars(head.data() + digits, head.data() + head.size(), count);
    const std::size_t length = head.find_first_not_of("0123456789", digits) - digits;
    if (count > text.size() || length > 18)
      refuse(file,
             fmt::format("promises {} elements in {} bytes", head.substr(digits, length), text.size()));
  }
}

void checkGltfCounts(const std::filesystem::path& file, std::string_view text) {
  if (text.substr(0, 4) == "glTF" && text.size() > 20) {  // binary: the JSON is the first chunk
    std::uint32_t length = 0;
    std::memcpy(&length, text.data() + 12, sizeof length);
    text = text.substr(20, length);
  }
  const auto document = nlohmann::json::parse(text, nullptr, false);
  if (!document.is_object()) refuse(file, "is no glTF");
  const auto accessors = document.value("accessors", nlohmann::json::array());
  if (!accessors.is_array()) refuse(file, "has accessors that are no list");
  for (const auto& accessor : accessors) {
    if (!accessor.is_object()) refuse(file, "has an accessor that is no object");
    const auto count = accessor.find("count");
    if (count == accessor.end() || !count->is_number_unsigned() ||
        count->get<std::uint64_t>() > 3 * std::uint64_t{mostItems})
      refuse(file, fmt::format("has an accessor whose count is not between 0 and {}", 3 * mostItems));
  }
}

}  // namespace

Mesh loadMesh(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  if (extension != ".obj" && extension != ".ply" && extension != ".gltf" && extension != ".glb")
    fail(ExitCode::usage, "the mesh {} is none of .obj, .ply, .gltf and .glb", file.string());
  const std::string text = readFile(file, "mesh");  // says why a file cannot be read, or is too large
  if (extension == ".ply") checkPlyCounts(file, text);
  if (extension == ".gltf" || extension == ".glb") checkGltfCounts(file, text);
  Assimp::Importer importer;
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  auto* const io = new FolderOnly(file);  // the importer's own from here
  importer.SetIOHandler(io);
  const aiScene* scene = importer.ReadFile(
      file.string(), aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_JoinIdenticalVertices);
  if (!io->refused().empty())
    refuse(file, fmt::format("names {}, which lies outside its folder", io->refused()));
  if (scene == nullptr || scene->mRootNode == nullptr) {
    std::string why = importer.GetErrorString();
    why = why.substr(0, why.find('\n'));
    refuse(file, fmt::format("cannot be read ({})", why.empty() ? "unknown reason" : why));
  }
  return Gatherer(file, *scene).gather();
}

}  // namespace simreel::sim
