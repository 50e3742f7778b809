#include "draw/exact/triangles/joined_surfaces.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/surface/surface_pass.hpp"
#include "draw/surface_fields.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

namespace simreel::draw {

struct JoinKernel {
  static constexpr auto file = "draw/exact/triangles/join.comp";
  using Variant = WorldVariant;
  WorldVertices surface;
  gl::In<"indices"> indices;
  gl::Uniform<"vertexCount", int> vertexCount;
  gl::Uniform<"firstVertex", int> firstVertex;
  gl::Uniform<"triangleCount", int> triangleCount;
  gl::Uniform<"firstTriangle", int> firstTriangle;
  gl::Uniform<"rowOf", glm::ivec2> rowOf;
  gl::Uniform<"owner", unsigned> owner;
  gl::Shared<"PlaceBlock"> places;
  gl::Shared<"NormalBlock"> normals;
  gl::Shared<"IndexBlock"> joined;
  gl::Shared<"OwnerBlock"> owners;
};

namespace {

constexpr std::size_t fewest = 3;
constexpr std::int64_t vertexLimit = 1 << 22;
constexpr std::int64_t maxMoving = 1 << 18;  ///< max number of vertices that are transformed in every
                                             ///< frame

}  // namespace

bool joinsSurfaces() {
  const char* asked = std::getenv("SIMREEL_JOIN_SURFACES");
  if (asked == nullptr || *asked == 0) return !gl::softwareDriver();
  const std::string word = asked;
  if (word != "yes" && word != "no")
    fail(ExitCode::usage, "SIMREEL_JOIN_SURFACES is \"yes\" or \"no\", not \"{}\"", word);
  return word == "yes";
}

bool JoinedSurfaces::suits(const std::vector<sim::Surface>& surfaces) {
  if (surfaces.size() < fewest) return false;
  std::int64_t vertices = 0;
  std::int64_t moving = 0;
  std::int64_t triangles = 0;
  for (const sim::Surface& surface : surfaces) {
    // Unused vertices would enlarge the bounds of the sun's shadow map.
    if (surface.arguments != nullptr || surface.vertexCapacity > surface.vertexCount) return false;
    if (castsShadow(surface) != castsShadow(surfaces.front())) return false;
    vertices += surface.vertexCount;
    moving += surface.still == 0 ? surface.vertexCount : 0;
    triangles += maxTrianglesOf(surface);
  }
  return vertices <= vertexLimit && moving <= maxMoving && triangles <= vertexLimit;
}

void JoinedSurfaces::makeRoom(std::size_t vertices, std::size_t triangles, std::size_t surfaces) {
  constexpr std::size_t texel = sizeof(glm::vec4);
  bool lost = reserve(places_, placeView_, "joined places", vertices * texel, GL_RGBA32F, texel);
  lost |= reserve(normals_, normalView_, "joined normals", vertices * texel, GL_RGBA32F, texel);
  lost |= reserve(indices_, "joined indices", 3 * triangles * sizeof(GLuint));
  lost |= reserve(owners_, ownerView_, "surfaces of triangles", triangles * sizeof(GLuint), GL_R32UI,
                  sizeof(GLuint));
  if (lost) parts_.clear();
  if (reserve(lookBuffer_, lookView_, "what surfaces are made of", 2 * surfaces * texel, GL_RGBA32F, texel))
    looks_.clear();
}

void JoinedSurfaces::put(const sim::Surface& surface, const Part& part, int number) {
  const gl::Texture corners = gl::Texture::view("indices", GL_R32UI, *surface.indices, sizeof(GLuint));
  const int triangles = maxTrianglesOf(surface);
  kernels_.of(worldVariant(surface))
      .dispatch(inRows(std::max(surface.vertexCount, triangles)),
                {.surface = worldVertices(surface),
                 .indices = corners,
                 .vertexCount = surface.vertexCount,
                 .firstVertex = part.firstVertex,
                 .triangleCount = triangles,
                 .firstTriangle = part.firstTriangle,
                 .rowOf = rowOf(surface),
                 .owner = 2U * static_cast<unsigned>(number) + (surface.doubleSided ? 1U : 0U),
                 .places = places_,
                 .normals = normals_,
                 .joined = indices_,
                 .owners = owners_});
}

void JoinedSurfaces::tellLooks(const std::vector<sim::Surface>& surfaces) {
  std::vector<glm::vec4> looks;
  for (const sim::Surface& surface : surfaces) {
    const scene::Material& material = *surface.material;
    looks.emplace_back(material.color, isReflective(material) ? 1.0F : 0.0F);
    looks.emplace_back(material.roughness, material.metallic, material.translucency, 0);
  }
  if (looks == looks_) return;
  looks_ = std::move(looks);
  lookBuffer_.write(0, std::as_bytes(std::span(looks_)));
}

bool JoinedSurfaces::join(const std::vector<sim::Surface>& surfaces) {
  if (!joinsSurfaces() || !suits(surfaces)) return false;
  std::vector<Part> parts;
  int vertices = 0;
  int triangles = 0;
  for (const sim::Surface& surface : surfaces) {
    parts.push_back({surface.still, surface.model, surface.doubleSided, vertices, triangles});
    vertices += surface.vertexCount;
    triangles += maxTrianglesOf(surface);
  }
  makeRoom(static_cast<std::size_t>(vertices), static_cast<std::size_t>(triangles), surfaces.size());
  tellLooks(surfaces);
  parts_.resize(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].still != 0 && parts[i] == parts_[i]) continue;
    put(surfaces[i], parts[i], static_cast<int>(i));
    parts_[i] = parts[i];
  }
  gl::barrier();
  surface_ = {};
  surface_.positions = &placeView_;
  surface_.normals = &normalView_;
  surface_.vertexCount = vertices;
  surface_.indices = &indices_;
  surface_.indexCount = 3 * triangles;
  surface_.material = surfaces.front().material;
  return true;
}

}  // namespace simreel::draw
