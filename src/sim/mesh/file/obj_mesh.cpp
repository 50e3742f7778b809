#include "base/error.hpp"
#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/library_materials.hpp"
#include "sim/mesh/file/polygon_meshes.hpp"
#include "sim/mesh/file/texture_place.hpp"
#include "sim/polygons/cut.hpp"
#include "sim/polygons/distinct.hpp"
#include "sim/polygons/obj.hpp"
#include "sim/polygons/problem.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace simreel::sim {

namespace {

/// Key of a vertex: its position, its uv, the source of its normal, and an index within that source.
enum class NormalOf : std::uint32_t { file, group, face };
using VertexKey = std::array<std::uint32_t, 4>;

template <std::size_t words>
struct KeyHash {
  std::uint64_t operator()(const std::array<std::uint32_t, words>& key) const {
    WordHash hash;
    for (const std::uint32_t word : key) hash.add(word);
    return hash.value();
  }
};

class ObjMesh {
 public:
  ObjMesh(const std::filesystem::path& file, std::string_view text, MeshNormals normals)
      : obj_(parseObj(text, maxMeshItems)), builder_(file) {
    if (normals == MeshNormals::shared)
      for (ObjFile::Face& face : obj_.faces) face.smooth = 1;
  }

  [[nodiscard]] const ObjFile& file() const { return obj_; }

  Mesh make() {
    if (obj_.faces.empty() && !obj_.notDrawn.empty())
      throw PolygonProblem(fmt::format("holds no triangle, but {}", fmt::join(obj_.notDrawn, ", ")));
    const std::vector<std::size_t> order = byMaterial();
    for (std::size_t first = 0; first < order.size();) {
      std::size_t end = first;
      while (end < order.size() && materialAt(order[end]) == materialAt(order[first])) ++end;
      addPart(std::span(order).subspan(first, end - first));
      first = end;
    }
    Mesh mesh = builder_.finish();
    mesh.undrawn = std::move(obj_.notDrawn);
    return mesh;
  }

 private:
  [[nodiscard]] int materialAt(std::size_t face) const { return obj_.faces[face].material; }

  /// Returns the face indices in file order, grouped by material. Materials are ordered by their first
  /// face.
  [[nodiscard]] std::vector<std::size_t> byMaterial() const {
    std::vector<std::size_t> place(obj_.materials.size() + 1, 0);
    std::size_t places = 0;
    const auto at = [&](std::size_t face) -> std::size_t& {
      return place[static_cast<std::size_t>(materialAt(face)) + 1];
    };
    for (std::size_t i = 0; i < obj_.faces.size(); ++i)
      if (at(i) == 0) at(i) = ++places;
    std::vector<std::size_t> order(obj_.faces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
    return order;
  }

  [[nodiscard]] std::span<const ObjFile::Corner> cornersOf(const ObjFile::Face& face) const {
    return std::span(obj_.corners).subspan(face.first, face.count);
  }

  void addPart(std::span<const std::size_t> faces) {
    Distinct<VertexKey, KeyHash<4>> vertices;
    std::vector<std::array<unsigned, 3>> triangles, cut;
    std::vector<glm::vec3> places;
    std::vector<unsigned> numbers;
    bool hasUvs = false;
    for (const std::size_t number : faces) {
      const ObjFile::Face& face = obj_.faces[number];
      places.clear();
      numbers.clear();
      cut.clear();
      for (const ObjFile::Corner& corner : cornersOf(face)) {
        hasUvs = hasUvs || corner.uv >= 0;
        places.push_back(obj_.places[static_cast<std::size_t>(corner.place)]);
        numbers.push_back(vertices.number(keyOf(corner, face, number)).first);
      }
      cutter_.cut(places, cut);
      for (const auto& [a, b, c] : cut) triangles.push_back({numbers[a], numbers[b], numbers[c]});
    }
    builder_.begin(vertices.keys().size(), triangles.size(), glm::mat4(1), hasUvs,
                   materialAt(faces.front()));
    for (const VertexKey& key : vertices.keys()) addVertex(key);
    for (const auto& triangle : triangles) builder_.triangle(triangle);
  }

  static VertexKey keyOf(const ObjFile::Corner& corner, const ObjFile::Face& face, std::size_t number) {
    const auto place = static_cast<std::uint32_t>(corner.place), uv = static_cast<std::uint32_t>(corner.uv);
    const auto of = [&](NormalOf kind, std::uint32_t which) {
      return VertexKey{place, uv, static_cast<std::uint32_t>(kind), which};
    };
    if (corner.normal >= 0) return of(NormalOf::file, static_cast<std::uint32_t>(corner.normal));
    if (face.smooth > 0) return of(NormalOf::group, face.smooth);
    return of(NormalOf::face, static_cast<std::uint32_t>(number));
  }

  void addVertex(const VertexKey& key) {
    const auto [place, uvNumber, kind, which] = key;
    glm::vec3 normal(0);
    if (static_cast<NormalOf>(kind) == NormalOf::file) normal = obj_.normals[which];
    if (static_cast<NormalOf>(kind) == NormalOf::face) normal = normalOf(obj_.faces[which]);
    // In OBJ, v is 0 at an image's last row; in Mesh, at the first.
    glm::vec2 uv(0);
    if (static_cast<int>(uvNumber) >= 0) uv = {obj_.uvs[uvNumber].x, 1.0F - obj_.uvs[uvNumber].y};
    if (obj_.colors.empty())
      builder_.vertex(obj_.places[place], normal, uv);
    else
      builder_.vertex(obj_.places[place], normal, uv, linearColor(obj_.colors[place]));
    if (static_cast<NormalOf>(kind) != NormalOf::group) return;
    const auto [shared, fresh] = smoothed_.number({place, which});
    if (fresh) firstOf_.push_back(builder_.vertexCount() - 1);
    builder_.shareNormal(firstOf_[shared]);
  }

  glm::vec3 normalOf(const ObjFile::Face& face) {
    corners_.clear();
    for (const ObjFile::Corner& corner : cornersOf(face))
      corners_.push_back(obj_.places[static_cast<std::size_t>(corner.place)]);
    const glm::dvec3 normal = polygonNormal(corners_);
    const double length = glm::length(normal);
    return length > 0 ? glm::vec3(normal / length) : glm::vec3(0);
  }

  ObjFile obj_;
  MeshBuilder builder_;
  PolygonCutter cutter_;
  std::vector<glm::vec3> corners_;
  Distinct<std::array<std::uint32_t, 2>, KeyHash<2>> smoothed_;  ///< pairs of position and smoothing group
  std::vector<std::size_t> firstOf_;                             ///< index of the first vertex for each
                                                                 ///< pair in smoothed_
};

}  // namespace

Mesh readObj(const std::filesystem::path& file, std::string_view text, MeshNormals normals) {
  try {
    ObjMesh obj(file, text, normals);
    for (const std::string& library : obj.file().libraries) checkLibrary(file, library);
    Mesh mesh = obj.make();
    addLibraryMaterials(file, obj.file().libraries, obj.file().materials, mesh);
    placeTextures(mesh);
    return mesh;
  } catch (const PolygonProblem& problem) {
    refuseMesh(file, problem.what());
  }
}

}  // namespace simreel::sim
