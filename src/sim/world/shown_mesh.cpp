#include "sim/world/shown_mesh.hpp"

#include "sim/core/shader_code.hpp"
#include "sim/kernels/copies.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/mesh/shapes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace simreel::sim {

namespace {

/// Returns the elements of a buffer from the byte offset `offset` on, but at most `maximum` elements.
template <class T>
std::vector<T> elementsOf(GLuint buffer, std::size_t offset, std::size_t maximum) {
  GLint64 bytes = 0;
  glGetNamedBufferParameteri64v(buffer, GL_BUFFER_SIZE, &bytes);
  const auto room = static_cast<std::size_t>(bytes) - std::min(static_cast<std::size_t>(bytes), offset);
  std::vector<T> elements(std::min(maximum, room / sizeof(T)));
  if (elements.empty()) return elements;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(buffer, static_cast<GLintptr>(offset),
                          static_cast<GLsizeiptr>(elements.size() * sizeof(T)), elements.data());
  return elements;
}

std::vector<glm::vec4> texelsOf(const gl::Texture& view, std::size_t maximum) {
  return elementsOf<glm::vec4>(view.buffer(), view.offset(), maximum);
}

std::size_t verticesOf(const Surface& surface) {
  return static_cast<std::size_t>(std::max(surface.vertexCount, surface.vertexCapacity));
}

/// Bit patterns of a position's coordinates, which identify a vertex. -0 has the same bits as 0.
using Corner = std::array<std::uint32_t, 3>;

Corner cornerOf(const glm::vec3& p) {
  return {std::bit_cast<std::uint32_t>(p.x + 0.0F), std::bit_cast<std::uint32_t>(p.y + 0.0F),
          std::bit_cast<std::uint32_t>(p.z + 0.0F)};
}

using Triangle = std::array<Corner, 3>;

/// Returns the triangles, in world space, of a surface with stored vertices. Returns nothing for a grid and
/// for a surface that the vertex shader deforms.
std::vector<Triangle> trianglesOf(const Surface& surface) {
  std::vector<Triangle> triangles;
  if (surface.normals == nullptr || surface.deform != nullptr || surface.heights != nullptr)
    return triangles;
  const auto vertices = texelsOf(*surface.positions, verticesOf(surface));
  const auto indices =
      elementsOf<unsigned>(surface.indices->name(), 0, static_cast<std::size_t>(surface.indexCount));
  std::vector<Corner> corners;
  corners.reserve(vertices.size());
  for (const glm::vec4& v : vertices)
    corners.push_back(cornerOf(glm::vec3(surface.model * glm::vec4(glm::vec3(v), 1.0F))));
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    if (std::max({indices[i], indices[i + 1], indices[i + 2]}) < corners.size())
      triangles.push_back({corners[indices[i]], corners[indices[i + 1]], corners[indices[i + 2]]});
  return triangles;
}

/// Determines, for each triangle of a mesh that several surfaces draw, the index of the surface that draws
/// it.
class Parts {
 public:
  explicit Parts(const std::vector<Surface>& surfaces) {
    for (unsigned i = 0; i < surfaces.size(); ++i)
      for (const Triangle& triangle : trianglesOf(surfaces[i])) parts_.emplace(triangle, i);
  }
  /// Returns the surface index of each triangle. Triangles that no surface draws get the index `otherwise`.
  [[nodiscard]] std::vector<unsigned> of(const MeshTable& mesh, unsigned otherwise) const {
    std::vector<unsigned> parts;
    parts.reserve(mesh.indices.size() / 3);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k) triangle[k] = cornerOf(mesh.positions[mesh.indices[i + k]]);
      const auto found = parts_.find(triangle);
      parts.push_back(found == parts_.end() ? otherwise : found->second);
    }
    return parts;
  }

 private:
  std::map<Triangle, unsigned> parts_;
};

/// Returns a unit normal transformed by a model matrix, with the same bits as placed() of sim/mesh.
glm::vec3 turned(const glm::mat4& model, const glm::vec4& normal) {
  if (glm::mat3(model) == glm::mat3(1)) return glm::vec3(normal);
  return glm::normalize(glm::vec3(model * glm::vec4(glm::vec3(normal), 0.0F)));
}

struct CornerHash {
  std::size_t operator()(const std::array<Corner, 2>& vertex) const {
    std::size_t hash = 0;
    for (const Corner& corner : vertex)
      for (const std::uint32_t word : corner) hash = (hash ^ word) * 0x9E3779B97F4A7C15ULL;
    return hash;
  }
};

/// Returns the colours of a surface's vertices, from its palette or its vertex colours. Empty if the
/// surface has neither.
std::vector<glm::vec3> colorsOf(const Surface& surface, const std::vector<glm::vec4>& vertices) {
  constexpr std::size_t largestPalette = 65536;
  std::vector<glm::vec3> colors;
  if (surface.palette != nullptr) {
    const auto palette = texelsOf(*surface.palette, largestPalette);
    const auto last = static_cast<float>(palette.size() - 1);
    for (const glm::vec4& vertex : vertices)
      colors.emplace_back(palette[static_cast<std::size_t>(vertex.w >= 0 ? std::min(vertex.w, last) : 0)]);
  } else if (surface.colors != nullptr) {
    for (const glm::vec4& color : texelsOf(*surface.colors, vertices.size())) colors.emplace_back(color);
  }
  return colors;
}

/// Returns the colours of a mesh's vertices; vertices without a colour are white. If the surface `first`
/// does not have exactly the vertices of the mesh, vertices are matched by position and normal. Empty if no
/// surface has colours.
std::vector<glm::vec3> colorsOf(const std::vector<Surface>& surfaces, const Surface& first,
                                const MeshTable& mesh) {
  if (static_cast<std::size_t>(first.vertexCount) == mesh.positions.size()) {
    std::vector<glm::vec3> colors = colorsOf(first, texelsOf(*first.positions, verticesOf(first)));
    if (!colors.empty()) colors.resize(mesh.positions.size(), glm::vec3(1));
    return colors;
  }
  std::unordered_map<std::array<Corner, 2>, glm::vec3, CornerHash> known;
  for (const Surface& surface : surfaces) {
    if (surface.normals == nullptr) continue;
    const auto vertices = texelsOf(*surface.positions, verticesOf(surface));
    const auto normals = texelsOf(*surface.normals, vertices.size());
    const auto colors = colorsOf(surface, vertices);
    for (std::size_t i = 0; i < colors.size() && i < normals.size(); ++i)
      known.emplace(std::array{cornerOf(glm::vec3(surface.model * glm::vec4(glm::vec3(vertices[i]), 1.0F))),
                               cornerOf(turned(surface.model, normals[i]))},
                    colors[i]);
  }
  std::vector<glm::vec3> colors;
  if (known.empty()) return colors;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const auto found = known.find({cornerOf(mesh.positions[i]), cornerOf(mesh.normals[i])});
    colors.push_back(found == known.end() ? glm::vec3(1) : found->second);
  }
  return colors;
}

std::vector<Surface> surfacesOf(const World& world, std::size_t object) {
  std::vector<Surface> found;
  const Drawables drawables = world.drawables();
  for (const Surface& surface : drawables.surfaces)
    if (objectName(surface) == world.objectName(object)) found.push_back(surface);
  return found;
}

std::vector<Instances> instancesOf(const World& world, std::size_t object) {
  std::vector<Instances> found;
  const Drawables drawables = world.drawables();
  for (const Instances& instances : drawables.instances)
    if (objectName(instances) == world.objectName(object)) found.push_back(instances);
  return found;
}

/// Returns the index of the last surface that has as many vertices as the mesh, and therefore draws all of
/// the mesh; 0 if there is none.
std::size_t mainSurface(const std::vector<Surface>& surfaces, const MeshTable& mesh) {
  for (std::size_t i = surfaces.size(); i-- > 0;)
    if (static_cast<std::size_t>(surfaces[i].vertexCount) == mesh.positions.size()) return i;
  return 0;
}

/// Returns the copy's colour as glsl/draw/instances/instance_list.glsl computes it.
glm::vec3 copyColor(const Instances& look, const glm::vec4& place, const glm::vec4& velocity) {
  if (look.colors == nullptr || look.colors->empty()) return glm::vec3(1);
  const float value = look.colorBy == Instances::ColorBy::speed  ? glm::length(glm::vec3(velocity))
                      : look.colorBy == Instances::ColorBy::mass ? place.w
                                                                 : velocity.w;
  const std::vector<glm::vec3>& stops = *look.colors;
  const float span = look.colorRange.y - look.colorRange.x;
  const float share = span == 0 ? 0.0F : std::clamp((value - look.colorRange.x) / span, 0.0F, 1.0F);
  const float at = share * static_cast<float>(stops.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  return glm::mix(stops[below], stops[std::min(below + 1, stops.size() - 1)],
                  at - static_cast<float>(below));
}

/// Returns a sphere of diameter 1, or the mesh from the file of `look`.
MeshTable shapeOf(const Instances& look) {
  constexpr int parts = 4;  // gives 320 triangles
  const Mesh mesh = look.shape == Instances::Shape::mesh ? loadMesh(look.mesh) : geodesicMesh(0.5F, parts);
  MeshTable shape;
  shape.positions = mesh.positions;
  shape.normals = mesh.normals;
  shape.uvs = mesh.uvs;
  shape.indices = mesh.indices;
  return shape;
}

ShownCopies shown(const Instances& look) {
  ShownCopies copies;
  copies.material = look.material;
  if (look.additive) copies.glow = look.brightness;
  const auto count = static_cast<std::size_t>(look.capacity);
  const auto places = texelsOf(*look.positions, count), velocities = texelsOf(*look.velocities, count);
  const auto turns = look.turns != nullptr ? texelsOf(*look.turns, count) : velocities;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::vec4 &place = places[i], &velocity = velocities.at(i);
    const float far = std::abs(place.x) + std::abs(place.y) + std::abs(place.z);
    if (!(velocity.w >= 0 && far < 1e6F)) continue;
    const float masses = std::max(place.w, 0.0F) / look.massReference;
    copies.places.emplace_back(place);
    copies.scales.push_back(
        look.massExponent == 0 ? look.size : look.size * shader::exactPow(masses, look.massExponent));
    if (look.turning != Instances::Turning::none)
      copies.turns.push_back(glm::normalize(glm::quat_cast(copyAxes(look.turning, turns.at(i)))));
    if (look.colorBy != Instances::ColorBy::material)
      copies.colors.push_back(copyColor(look, place, velocity));
  }
  if (!copies.places.empty()) copies.shape = shapeOf(look);
  return copies;
}

/// True for a surface whose vertices are stored as they are drawn.
bool isStored(const Surface& surface) {
  return surface.normals != nullptr && surface.deform == nullptr && surface.heights == nullptr &&
         surface.arguments == nullptr;
}

/// Appends a surface in world space. Returns false if it has no texture coordinates.
bool append(MeshTable& mesh, const Surface& surface) {
  const auto first = static_cast<unsigned>(mesh.positions.size());
  const auto vertices = texelsOf(*surface.positions, verticesOf(surface));
  const auto normals = texelsOf(*surface.normals, vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    mesh.positions.emplace_back(surface.model * glm::vec4(glm::vec3(vertices[i]), 1.0F));
    mesh.normals.push_back(turned(surface.model, normals.at(i)));
  }
  for (const unsigned index :
       elementsOf<unsigned>(surface.indices->name(), 0, static_cast<std::size_t>(surface.indexCount)))
    mesh.indices.push_back(first + index);
  mesh.doubleSided = mesh.doubleSided || surface.doubleSided;
  if (surface.uvs == nullptr) return false;
  const auto uvs = elementsOf<glm::vec2>(surface.uvs->buffer(), surface.uvs->offset(), vertices.size());
  mesh.uvs.insert(mesh.uvs.end(), uvs.begin(), uvs.end());
  return uvs.size() == vertices.size();
}

}  // namespace

bool showsMesh(const World& world, std::size_t object) {
  const std::vector<Surface> surfaces = surfacesOf(world, object);
  return world.object(object).mesh() || std::any_of(surfaces.begin(), surfaces.end(), isStored);
}

std::optional<MeshTable> shownMesh(const World& world, std::size_t object) {
  if (auto own = world.object(object).mesh()) return own;
  MeshTable mesh;
  bool textured = true;
  for (const Surface& surface : surfacesOf(world, object))
    if (isStored(surface)) textured = append(mesh, surface) && textured;
  if (mesh.indices.empty()) return std::nullopt;
  if (!textured) mesh.uvs.clear();
  return mesh;
}

MeshLooks looksOfMesh(const World& world, std::size_t object, const MeshTable& mesh) {
  MeshLooks looks;
  const std::vector<Surface> surfaces = surfacesOf(world, object);
  for (const Surface& surface : surfaces) {
    looks.materials.push_back(surface.material);
    looks.doubleSided = looks.doubleSided || surface.doubleSided;
  }
  if (surfaces.empty()) {
    for (const Instances& copies : instancesOf(world, object)) looks.materials.push_back(copies.material);
    return looks;
  }
  auto main = static_cast<unsigned>(mainSurface(surfaces, mesh));
  const Surface& first = surfaces[main];
  if (!first.material->skin)
    looks.colors = colorsOf(surfaces, first, mesh);  // A skin replaces the vertex
                                                     // colours.
  looks.ownColors = first.palette != nullptr;
  for (const Instances& copies : instancesOf(world, object)) {
    if (copies.shape != Instances::Shape::mesh) continue;
    main = static_cast<unsigned>(looks.materials.size());
    looks.materials.push_back(copies.material);
  }
  if (looks.materials.size() > 1) looks.partOf = Parts(surfaces).of(mesh, main);
  return looks;
}

bool showsCopies(const World& world, std::size_t object) {
  return !world.object(object).mesh() && !instancesOf(world, object).empty();
}

std::vector<ShownCopies> shownCopies(const World& world, std::size_t object) {
  std::vector<ShownCopies> found;
  if (!showsCopies(world, object)) return found;
  for (const Instances& one : instancesOf(world, object)) {
    ShownCopies copies = shown(one);
    if (!copies.places.empty()) found.push_back(std::move(copies));
  }
  return found;
}

}  // namespace simreel::sim
