#include "sim/mesh/file/builder.hpp"

#include "base/error.hpp"
#include "base/srgb.hpp"
#include "scene/value/asset_path.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace simreel::sim {

namespace fs = std::filesystem;

namespace {

thread_local std::set<fs::path> readable;  ///< readable folders, set by ReadableFolders

bool isReadable(const fs::path& named) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(fs::absolute(named, error), error);
  return !error && std::any_of(readable.begin(), readable.end(), [&](const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
  });
}

}  // namespace

void refuseMesh(const fs::path& file, const std::string& why) {
  fail(ExitCode::inputOutput, "the mesh {} {}", file.string(), why);
}

glm::vec3 linearColor(const glm::vec3& encoded) {
  const auto linear = [](float part) {
    return static_cast<float>(linearOfSrgb(std::clamp(static_cast<double>(part), 0.0, 1.0)));
  };
  return {linear(encoded.r), linear(encoded.g), linear(encoded.b)};
}

ReadableFolders::ReadableFolders(const fs::path& mesh) {
  readable = scene::foldersAround(mesh);
}
ReadableFolders::~ReadableFolders() {
  readable.clear();
}

fs::path resolveInMeshFolder(const fs::path& mesh, std::string_view name) {
  fs::path path = mesh.parent_path() / name;
  std::error_code error;
  if (name.find('\\') == std::string_view::npos || fs::exists(path, error)) return path;
  std::string slashes;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool beforeBlank = name[i] == '\\' && i + 1 < name.size() && name[i + 1] == ' ';
    if (!beforeBlank) slashes += name[i] == '\\' ? '/' : name[i];
  }
  return mesh.parent_path() / slashes;
}

bool liesBeside(const fs::path& mesh, const fs::path& named) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(mesh, error).parent_path(), error);
  if (error) return false;
  const fs::path path = fs::weakly_canonical(fs::absolute(named, error), error);
  const std::string inside = path.lexically_relative(folder).string();
  return !error && !inside.empty() && inside.rfind("..", 0) != 0;
}

std::string whyUnread(const fs::path& mesh, const fs::path& named) {
  if (!liesBeside(mesh, named) && !isReadable(named))
    return readable.empty() ? "it lies outside the mesh's folder"
                            : "it lies outside the folders that the scene may read; --assets DIR adds one";
  std::error_code error;
  return fs::is_regular_file(named, error) ? "" : "it does not exist or is not a regular file";
}

void MeshBuilder::begin(std::size_t vertices, std::size_t triangles, const glm::mat4& transform,
                        bool hasUvs, int material) {
  if (mesh_.positions.size() + vertices > 3 * maxMeshItems ||
      mesh_.indices.size() / 3 + triangles > maxMeshItems)
    refuseMesh(file_, fmt::format("has more than {} vertices or triangles; simplify it", maxMeshItems));
  transform_ = transform;
  const float determinant = glm::determinant(glm::mat3(transform));
  mirrored_ = determinant < 0;
  turn_ = glm::transpose(glm::inverse(glm::mat3(transform)));
  first_ = mesh_.positions.size();
  count_ = vertices;
  hasUvs_ = hasUvs_ || hasUvs;
  material_ = material;
}

void MeshBuilder::vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv) {
  const glm::vec3 p = transform_ * glm::vec4(position, 1);
  if (!(std::abs(p.x) + std::abs(p.y) + std::abs(p.z) < 1e9F))
    refuseMesh(file_, fmt::format("has a vertex that is not finite or farther than 1e9 m (number {})",
                                  mesh_.positions.size()));
  if (!(std::abs(uv.x) + std::abs(uv.y) < 1e9F))
    refuseMesh(file_, fmt::format("has a texture coordinate that is not finite or beyond 1e9 (vertex {})",
                                  mesh_.positions.size()));
  mesh_.positions.push_back(p);
  const glm::vec3 n = turn_ * normal;
  const float length = glm::length(n);
  mesh_.normals.push_back(length > 1e-20F && length < 1e20F ? n / length : glm::vec3(0));
  mesh_.uvs.push_back(uv);
  sharing_.push_back(static_cast<unsigned>(sharing_.size()));
  if (!mesh_.colors.empty()) mesh_.colors.emplace_back(1);
}

void MeshBuilder::vertex(const glm::vec3& position, const glm::vec3& normal, const glm::vec2& uv,
                         const glm::vec3& color) {
  const auto within = [](float part) {
    return part >= 0 ? std::min(part, 1e4F) : 0.0F;
  };  // also replaces NaN by 0
  vertex(position, normal, uv);
  mesh_.colors.resize(mesh_.positions.size(), glm::vec3(1));
  mesh_.colors.back() = {within(color.r), within(color.g), within(color.b)};
}

void MeshBuilder::triangle(const std::array<unsigned, 3>& corners) {
  for (const std::size_t k : {0U, mirrored_ ? 2U : 1U, mirrored_ ? 1U : 2U}) {
    if (corners[k] >= count_)
      refuseMesh(file_, fmt::format("has a triangle with vertex {} of {}", corners[k], count_));
    mesh_.indices.push_back(static_cast<unsigned>(first_ + corners[k]));
  }
  mesh_.materialOf.push_back(material_);
}

Mesh MeshBuilder::finish() {
  if (mesh_.indices.empty()) refuseMesh(file_, "holds no triangle");
  if (!hasUvs_) mesh_.uvs.clear();
  fillNormals();
  return std::move(mesh_);
}

/// Computes missing normals: the sum of the normals of the triangles around the vertex, weighted by area.
void MeshBuilder::fillNormals() {
  std::vector<glm::vec3> sums(mesh_.positions.size(), glm::vec3(0));
  for (std::size_t i = 0; i < mesh_.indices.size(); i += 3) {
    const glm::vec3& a = mesh_.positions[mesh_.indices[i]];
    const glm::vec3 normal =
        glm::cross(mesh_.positions[mesh_.indices[i + 1]] - a, mesh_.positions[mesh_.indices[i + 2]] - a);
    for (std::size_t k = 0; k < 3; ++k) sums[sharing_[mesh_.indices[i + k]]] += normal;
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    if (mesh_.normals[i] != glm::vec3(0)) continue;
    const glm::vec3& sum = sums[sharing_[i]];
    const float length = glm::length(sum);
    mesh_.normals[i] = length > 0 && std::isfinite(length) ? sum / length : glm::vec3(0, 1, 0);
  }
}

}  // namespace simreel::sim
