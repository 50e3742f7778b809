#include "base/error.hpp"
#include "sim/mesh/file/builder.hpp"
#include "sim/mesh/file/polygon_meshes.hpp"
#include "sim/polygons/cut.hpp"
#include "sim/polygons/ply.hpp"
#include "sim/polygons/problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <string>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Indices of the vertex properties that are read, or -1 for missing properties.
struct VertexLayout {
  explicit VertexLayout(const PlyElement& e)
      : place{e.find({"x"}), e.find({"y"}), e.find({"z"})},
        normal{e.find({"nx"}), e.find({"ny"}), e.find({"nz"})},
        uv{e.find({"u", "s", "texture_u", "texture_s"}), e.find({"v", "t", "texture_v", "texture_t"})},
        color{e.find({"red", "r", "diffuse_red"}), e.find({"green", "g", "diffuse_green"}),
              e.find({"blue", "b", "diffuse_blue"}), e.find({"alpha", "a", "diffuse_alpha"})} {}

  std::array<int, 3> place, normal;
  std::array<int, 2> uv;
  std::array<int, 4> color;
};

template <std::size_t count>
bool areComplete(const std::array<int, count>& properties) {
  return std::all_of(properties.begin(), properties.end(), [](int property) { return property >= 0; });
}

/// Returns the maximum colour value that this type can store.
double brightest(const PlyType& type) {
  if (type.kind == 'f') return 1;
  return std::exp2(8.0 * type.bytes - (type.kind == 'i' ? 1 : 0)) - 1;
}

class PlyMesh {
 public:
  PlyMesh(const std::filesystem::path& file, std::string_view text) : ply_(text), builder_(file) {
    for (std::size_t i = 0; i < ply_.elements().size(); ++i) lookAt(ply_.elements()[i], i);
    for (const std::string& comment : ply_.comments())
      if (comment.starts_with("TextureFile")) mesh_.ignored.push_back(quotedComment(comment));
  }

  Mesh make() {
    const std::size_t after =
        ply_.read([&](std::size_t element, std::uint64_t item, const PlyItem& values) {
          if (element == vertices_) vertex(values);
          if (const auto at = lists_.find(element); at != lists_.end()) {
            if (at->second.strips)
              strip(values.list(at->second.property), item);
            else
              face(values.list(at->second.property), item);
          }
        });
    if (after > 0) mesh_.undrawn.push_back(fmt::format("{} bytes after its last element", after));
    if (counts_.empty() && triangles_.empty() && !places_.empty())
      throw PolygonProblem("holds vertices and no face; \"particles\" draw its points");
    cutFaces();
    build();
    Mesh mesh = builder_.finish();
    mesh.ignored = std::move(mesh_.ignored);
    mesh.undrawn = std::move(mesh_.undrawn);
    if (fades_) mesh.ignored.emplace_back("the opacity of its vertices");
    return mesh;
  }

 private:
  static constexpr std::size_t noElement = std::numeric_limits<std::size_t>::max();
  static constexpr std::size_t kindLimit = 12;
  struct Indices {
    std::size_t property;
    bool strips;
  };

  static std::string quotedComment(const std::string& comment) { return comment.substr(0, 60); }

  void lookAt(const PlyElement& element, std::size_t number) {
    if (element.name == "vertex") {
      if (vertices_ != noElement) throw PolygonProblem("has two lists of vertices");
      if (element.count > maxMeshItems)
        throw PolygonProblem(fmt::format("has more than {} vertices; simplify it", maxMeshItems));
      vertices_ = number;
      layout_ = VertexLayout(element);
      if (!areComplete(layout_.place)) throw PolygonProblem("has vertices without x, y and z");
      for (std::size_t k = 0; k < 4; ++k)
        if (layout_.color[k] >= 0)
          brightest_[k] = brightest(element.properties[static_cast<std::size_t>(layout_.color[k])].type);
      return;
    }
    if (element.count == 0) return;
    if (element.name == "face" || element.name == "tristrips") {
      const int indices = element.find({"vertex_indices", "vertex_index"}, true);
      if (indices < 0) throw PolygonProblem("has faces without a list \"vertex_indices\"");
      lists_[number] = {static_cast<std::size_t>(indices), element.name == "tristrips"};
      if (element.find({"red", "r", "diffuse_red"}) >= 0)
        mesh_.ignored.emplace_back("the colours of its faces");
      if (element.find({"texcoord"}, true) >= 0)
        mesh_.ignored.emplace_back("the texture coordinates of its faces");
      return;
    }
    if (mesh_.undrawn.size() >= kindLimit) return;
    mesh_.undrawn.push_back(
        element.name == "edge"
            ? fmt::format("edges ({})", element.count)
            : fmt::format("elements \"{}\" ({})", element.name.substr(0, 40), element.count));
  }

  void vertex(const PlyItem& values) {
    const auto at = [&](int property) {
      return static_cast<float>(values[static_cast<std::size_t>(property)]);
    };
    places_.emplace_back(at(layout_.place[0]), at(layout_.place[1]), at(layout_.place[2]));
    if (areComplete(layout_.normal))
      normals_.emplace_back(at(layout_.normal[0]), at(layout_.normal[1]), at(layout_.normal[2]));
    if (areComplete(layout_.uv)) uvs_.emplace_back(at(layout_.uv[0]), at(layout_.uv[1]));
    const auto color = [&](std::size_t k) {
      return static_cast<float>(values[static_cast<std::size_t>(layout_.color[k])] / brightest_[k]);
    };
    if (layout_.color[0] >= 0 && layout_.color[1] >= 0 && layout_.color[2] >= 0)
      colors_.push_back(linearColor({color(0), color(1), color(2)}));
    fades_ = fades_ || (layout_.color[3] >= 0 && color(3) < 1);
  }

  /// Returns a corner's vertex index; its upper bound is checked after all vertices have been read.
  static unsigned cornerIn(double value, std::uint64_t item) {
    if (!(value >= 0 && value < 4e9) || value != std::floor(value))
      throw PolygonProblem(fmt::format("has a face with vertex {} (number {})", value, item));
    return static_cast<unsigned>(value);
  }

  void face(std::span<const double> corners, std::uint64_t item) {
    if (corners.size() > maxCorners)
      throw PolygonProblem(fmt::format("has a face of {} corners (number {}), more than {}; cut it up",
                                       corners.size(), item, maxCorners));
    if (corners.size() < 3) {
      ++thin_;
      return;
    }
    for (const double corner : corners) corners_.push_back(cornerIn(corner, item));
    counts_.push_back(static_cast<unsigned>(corners.size()));
    checkSize(corners_.size());
  }

  /// Adds triangle strips. A strip ends at -1; every other triangle has reversed winding.
  void strip(std::span<const double> corners, std::uint64_t item) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (corners[i] == -1) first = i + 1;
      if (i < first + 2) continue;
      const unsigned a = cornerIn(corners[i - 2], item), b = cornerIn(corners[i - 1], item),
                     c = cornerIn(corners[i], item);
      if (a == b || b == c || c == a) continue;  // degenerate triangle that joins two strips
      if ((i - first) % 2 == 0)
        triangles_.push_back({a, b, c});
      else
        triangles_.push_back({b, a, c});
      checkSize(3 * triangles_.size());
    }
  }

  static void checkSize(std::size_t corners) {
    if (corners > 3 * maxMeshItems)
      throw PolygonProblem(fmt::format("has more than {} triangles; simplify it", maxMeshItems));
  }

  void checkCorner(unsigned corner) const {
    if (corner >= places_.size())
      throw PolygonProblem(fmt::format("has a face with vertex {} of {}", corner, places_.size()));
  }

  void cutFaces() {
    for (const auto& triangle : triangles_)
      for (const unsigned corner : triangle) checkCorner(corner);
    PolygonCutter cutter;
    std::vector<glm::vec3> places;
    std::vector<std::array<unsigned, 3>> cut;
    const unsigned* at = corners_.data();
    for (const unsigned count : counts_) {
      places.clear();
      cut.clear();
      for (unsigned k = 0; k < count; ++k) {
        checkCorner(at[k]);
        places.push_back(places_[at[k]]);
      }
      cutter.cut(places, cut);
      for (const auto& [a, b, c] : cut) triangles_.push_back({at[a], at[b], at[c]});
      at += count;
    }
    if (thin_ > 0) mesh_.undrawn.push_back(fmt::format("faces of fewer than three corners ({})", thin_));
  }

  /// Builds the mesh from the vertices that faces use, in file order.
  void build() {
    std::vector<unsigned> numbers(places_.size(), 0), used;
    for (const auto& triangle : triangles_)
      for (const unsigned corner : triangle) numbers[corner] = 1;
    for (unsigned vertex = 0; vertex < numbers.size(); ++vertex) {
      if (numbers[vertex] == 0) continue;
      numbers[vertex] = static_cast<unsigned>(used.size());
      used.push_back(vertex);
    }
    builder_.begin(used.size(), triangles_.size(), glm::mat4(1), !uvs_.empty());
    for (const unsigned vertex : used) {
      const glm::vec3 normal = normals_.empty() ? glm::vec3(0) : normals_[vertex];
      // In PLY, v is 0 at an image's last row; in Mesh, at the first.
      const glm::vec2 uv = uvs_.empty() ? glm::vec2(0) : glm::vec2(uvs_[vertex].x, 1.0F - uvs_[vertex].y);
      if (colors_.empty())
        builder_.vertex(places_[vertex], normal, uv);
      else
        builder_.vertex(places_[vertex], normal, uv, colors_[vertex]);
    }
    for (const auto& [a, b, c] : triangles_) builder_.triangle({numbers[a], numbers[b], numbers[c]});
  }

  PlyFile ply_;
  MeshBuilder builder_;
  Mesh mesh_;  ///< Mesh of which only the lists `ignored` and `undrawn` are used.
  std::size_t vertices_ = noElement;
  VertexLayout layout_{PlyElement()};
  std::array<double, 4> brightest_{1, 1, 1, 1};
  std::map<std::size_t, Indices> lists_;  ///< maps the index of an element to the element's lists of vertex
                                          ///< indices
  std::vector<glm::vec3> places_, normals_, colors_;
  std::vector<glm::vec2> uvs_;
  std::vector<unsigned> corners_, counts_;
  std::vector<std::array<unsigned, 3>> triangles_;
  std::size_t thin_ = 0;
  bool fades_ = false;
};

}  // namespace

Mesh readPly(const std::filesystem::path& file, std::string_view text) {
  try {
    return PlyMesh(file, text).make();
  } catch (const PolygonProblem& problem) {
    refuseMesh(file, problem.what());
  }
}

}  // namespace simreel::sim
