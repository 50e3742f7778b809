#include "draw/exact/triangles/triangle_raster.hpp"

#include "base/error.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "draw/exact/triangles/triangle_kernels.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace simreel::draw {

namespace {

constexpr std::int64_t maxIds = 0xfffffff0;  // the last ones say ground, and nothing

}  // namespace

TriangleRaster::TriangleRaster(Into into, int samples, int smallPixels, int fanRoom, int mediumPixels,
                               int binRoom)
    : into_(into),
      samples_(samples),
      smallPixels_(smallPixels),
      fanRoom_(fanRoom),
      mediumPixels_(mediumPixels),
      binRoom_(binRoom),
      bins_(intoDefines(), samples) {}

void TriangleRaster::number(const std::vector<const sim::Surface*>& surfaces, unsigned firstId) {
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  int fans = 0;
  drawn_.resize(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const sim::Surface* surface = surfaces[i];
    Drawn& next = drawn_[i];
    next.surface = surface;
    next.firstVertex = static_cast<int>(vertices);
    next.firstIndex = static_cast<int>(3 * triangles);
    next.maxTriangles = maxTrianglesOf(*surface);
    next.firstId = firstId + static_cast<unsigned>(triangles);
    if (next.indices)
      next.indices.show(*surface->indices, sizeof(GLuint));
    else
      next.indices = gl::Texture::view("indices", GL_R32UI, *surface->indices, sizeof(GLuint));
    next.firstFan = fans;
    next.fans = std::min(next.maxTriangles, fanRoom_ / static_cast<int>(surfaces.size()));
    fans += next.fans;
    vertices += verticesOf(*surface);
    triangles += next.maxTriangles;
    if (3 * triangles > INT32_MAX || vertices > INT32_MAX || firstId + triangles > maxIds)
      fail(ExitCode::device,
           "the exact rasterizer numbers {} triangles of one picture, and these are more; set "
           "\"rasterizer\" "
           "to \"driver\"",
           INT32_MAX / 3);
  }
  reserve(vertices_, vertexView_, "vertices on the picture", static_cast<std::size_t>(vertices) * 16,
          GL_RGBA32UI, 16);
  reserveLists(surfaces.size(), triangles, fans);
}

void TriangleRaster::number(const TriangleLists& lists, const std::vector<MapFace>& faces,
                            const gl::Buffer& views, int first) {
  number(lists, faces);
  faceViews_ = &views;
  firstView_ = first;
}

void TriangleRaster::number(const TriangleLists& lists, const std::vector<MapFace>& faces) {
  lists_ = lists;
  faceViews_ = nullptr;
  drawn_.resize(faces.size());
  const int fans = std::min(lists.room, fanRoom_ / std::max(static_cast<int>(faces.size()), 1));
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const int number = static_cast<int>(i);
    Drawn& next = drawn_[i];
    next.list = number;
    next.firstIndex = 3 * number * lists.room;
    next.maxTriangles = lists.room;
    next.firstFan = number * fans;
    next.fans = fans;
    next.face = faces[i];
  }
  const auto count = static_cast<std::int64_t>(faces.size());
  reserveLists(faces.size(), count * lists.room, static_cast<int>(count) * fans);
}

void TriangleRaster::reserveLists(std::size_t draws, std::int64_t triangles, int fans) {
  reserve(large_, largeView_, "large triangles", static_cast<std::size_t>(triangles) * sizeof(GLuint),
          GL_R32UI, sizeof(GLuint));
  reserve(counters_, counterView_, "counts of large triangles", 2 * draws * sizeof(GLuint), GL_R32UI,
          sizeof(GLuint));
  reserve(largeGroups_, "groups for large triangles", draws * GroupCounts::bytes);
  reserve(surfaceGroups_, "groups for triangles", draws * GroupCounts::bytes);
  if (into_ == Into::sunMap) return;  // never clipped
  reserve(clipGroups_, "groups for clipping", draws * GroupCounts::bytes);
  reserve(roomlessGroups_, "groups for triangles not clipped", draws * GroupCounts::bytes);
  reserve(fans_, fanView_, "clipped triangles", static_cast<std::size_t>(fans) * 128, GL_RGBA32UI, 16);
}

const gl::Program& TriangleRaster::vertexProgram(const sim::Surface& surface, bool parallel) {
  const std::array<bool, 3> key{surface.normals == nullptr, surface.deform != nullptr, parallel};
  const auto found = vertexPrograms_.find(key);
  if (found != vertexPrograms_.end()) return found->second;
  gl::Defines defines;
  if (key[0]) defines.emplace_back("GRID", "1");
  if (key[1]) defines.emplace_back("DEFORMED", "1");
  if (parallel) defines.emplace_back("PARALLEL", "1");
  if (into_ == Into::sunMap) defines.emplace_back("SUN_MAP", "1");
  return vertexPrograms_.emplace(key, gl::Program::compute("draw/exact/triangles/vertices.comp", defines))
      .first->second;
}

gl::Defines TriangleRaster::intoDefines() const {
  if (into_ == Into::picture) return {};
  return {{into_ == Into::sunMap ? "SUN_MAP" : "LAMP_MAP", "1"}};
}

const gl::Program& TriangleRaster::program(const Variant& variant) {
  const auto found = programs_.find(variant);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = {{"SAMPLES", std::to_string(samples_)}, {"PASS", std::to_string(variant.pass)}};
  for (const auto& define : definesOf(variant.layout)) defines.push_back(define);
  if (variant.path == trianglesPath)
    for (const auto& define : laneDefines()) defines.push_back(define);
  if (variant.counted) defines.emplace_back("COUNTED", "1");
  if (variant.clips) defines.emplace_back("CLIPS", "1");
  if (variant.bins) defines.emplace_back("BINS", "1");
  if (variant.joined) defines.emplace_back("JOINED", "1");
  if (variant.faces)
    defines.emplace_back("FACES", variant.path == largePath ? "gl_WorkGroupID.y" : "gl_WorkGroupID.z");
  if (variant.cut) defines.emplace_back("CUTOUT", "1");
  if (variant.cut && variant.grid) defines.emplace_back("GRID", "1");
  if (variant.layer) defines.emplace_back("LAYER", "1");
  for (const auto& define : intoDefines()) defines.push_back(define);
  return programs_.emplace(variant, gl::Program::compute(variant.path, defines)).first->second;
}

void TriangleRaster::makeVertices(const Visibility& into) {
  vertices_.bindStorage(outVertexBinding);
  for (const Drawn& drawn : asked_) {
    const sim::Surface& surface = *drawn.surface;
    const gl::Program& program = vertexProgram(surface, into.layout().parallel);
    program.set("model", surface.model);
    program.set("grid", surface.grid);
    program.set("vertexCount", verticesOf(surface));
    program.set("firstVertex", drawn.firstVertex);
    program.set("mapTexels", static_cast<float>(into.size().x));
    bindPositions(surface, program);
    if (surface.normals != nullptr) surface.normals->bind(normalUnit);
    bindDeformation(surface);
    dispatchRows(program, verticesOf(surface));
  }
}

void TriangleRaster::bind(const Drawn& drawn, const gl::Program& program) const {
  if (into_ == Into::lampMap) {
    lists_.places->bind(vertexUnit);
    lists_.indices->bind(indexUnit);
    lists_.numbers->bind(tileListUnit);
    lists_.counts->bindStorage(drawArgumentBinding);
    drawn.face.views->bindUniform(viewBinding, drawn.face.view, viewBytes);
    program.set("list", drawn.list);
  } else {
    vertexView_.bind(vertexUnit);
    drawn.indices.bind(indexUnit);
    if (drawn.surface->arguments != nullptr) drawn.surface->arguments->bindStorage(drawArgumentBinding);
  }
  program.set("rowOf", into_ == Into::lampMap ? glm::ivec2(0) : rowOf(*drawn.surface));
  program.set("firstVertex", drawn.firstVertex);
  program.set("firstIndex", drawn.firstIndex);
  program.set("triangleCount", drawn.maxTriangles);
  program.set("firstId", drawn.firstId);
  program.set("firstFan", drawn.firstFan);
  program.set("fanRoom", drawn.fans);
}

}  // namespace simreel::draw
