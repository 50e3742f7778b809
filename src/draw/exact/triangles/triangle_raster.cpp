#include "draw/exact/triangles/triangle_raster.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/triangle_kernels.hpp"

#include <algorithm>
#include <cstdint>

namespace simreel::draw {

namespace {

constexpr std::int64_t maxIds = 0xfffffff0;  // max number of ids; larger values mean the ground and empty
                                             // samples

}  // namespace

TriangleRaster::TriangleRaster(Into into, int samples, int smallPixels, int fanRoom, int mediumPixels,
                               int binRoom)
    : into_(into),
      samples_(samples),
      smallPixels_(smallPixels),
      fanRoom_(fanRoom),
      mediumPixels_(mediumPixels),
      binRoom_(binRoom) {}

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
      next.indices.attach(*surface->indices, sizeof(GLuint));
    else
      next.indices = gl::Texture::view("indices", GL_R32UI, *surface->indices, sizeof(GLuint));
    next.firstFan = fans;
    next.fans = std::min(next.maxTriangles, fanRoom_ / static_cast<int>(surfaces.size()));
    fans += next.fans;
    vertices += verticesOf(*surface);
    triangles += next.maxTriangles;
    if (3 * triangles > INT32_MAX || vertices > INT32_MAX || firstId + triangles > maxIds)
      fail(ExitCode::device,
           "the picture has more than {} triangles, the limit of the exact rasterizer; reduce them, or set "
           "\"rasterizer\" to \"driver\"",
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
  if (into_ == Into::sunMap) return;  // triangles are never clipped in the sun's map
  reserve(clipGroups_, "groups for clipping", draws * GroupCounts::bytes);
  reserve(roomlessGroups_, "groups for triangles not clipped", draws * GroupCounts::bytes);
  reserve(fans_, fanView_, "clipped triangles", static_cast<std::size_t>(fans) * 128, GL_RGBA32UI, 16);
}

void TriangleRaster::makeVertices(const Visibility& into) {
  for (const Drawn& drawn : entries_) {
    const sim::Surface& surface = *drawn.surface;
    vertexKernels_
        .of({.surface = worldVariant(surface),
             .parallel = into.layout().parallel,
             .sunMap = into_ == Into::sunMap})
        .dispatch(inRows(verticesOf(surface)), {.surface = worldVertices(surface),
                                                .vertexCount = verticesOf(surface),
                                                .firstVertex = drawn.firstVertex,
                                                .mapTexels = static_cast<float>(into.size().x),
                                                .vertices = vertices_});
  }
}

TriangleSource TriangleRaster::source(const Drawn& drawn) const {
  const bool map = into_ == Into::lampMap;
  return {.vertices = vertexView_,
          .places = orNone(lists_.places),
          .indices = map ? *lists_.indices : drawn.indices,
          .firstVertex = drawn.firstVertex,
          .triangleCount = drawn.maxTriangles,
          .firstIndex = drawn.firstIndex,
          .counts = orNone(map ? lists_.counts : drawn.surface->arguments),
          .lists = orNone(lists_.numbers),
          .list = drawn.list,
          .rowOf = map ? glm::ivec2(0) : rowOf(*drawn.surface)};
}

}  // namespace simreel::draw
