#include "draw/exact/scene/merged_mesh.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/surface_fields.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <cstdint>

namespace simreel::draw {

struct MergeKernel {
  static constexpr auto file = "draw/exact/shadows/merge_mesh.comp";
  struct Variant {
    gl::Flag<"DEFORMED"> deformed;
    gl::Flag<"COUNTED"> counted;
  };
  WorldVertices surface;
  gl::In<"indices"> indices;
  gl::In<"DrawArgumentBlock"> arguments;
  gl::Uniform<"vertexCount", int> vertexCount;
  gl::Uniform<"firstVertex", int> firstVertex;
  gl::Uniform<"triangleCount", int> triangleCount;
  gl::Uniform<"rowOf", glm::ivec2> rowOf;
  gl::Shared<"VertexBlock"> places;
  gl::Shared<"IndexBlock"> merged;
  gl::Shared<"CountBlock"> count;
};

MergedMesh::MergedMesh() : count_("merged indices", 4 * sizeof(GLuint)) {}

void MergedMesh::merge(const std::vector<const sim::Surface*>& surfaces) {
  constexpr GLuint zero = 0;
  std::int64_t vertices = 0;
  std::int64_t triangles = 0;
  for (const sim::Surface* surface : surfaces) {
    vertices += verticesOf(*surface);
    triangles += maxTrianglesOf(*surface);
  }
  if (vertices > INT32_MAX || 3 * triangles > INT32_MAX)
    fail(ExitCode::device,
         "the picture has more than {} triangles, the limit of the exact rasterizer for shadows of lamps; "
         "reduce them, or set \"rasterizer\" to \"driver\"",
         INT32_MAX / 3);
  reserve(places_, placesView_, "places in the world", static_cast<std::size_t>(vertices) * 16, GL_RGBA32F,
          16);
  reserve(indices_, indicesView_, "merged triangles", static_cast<std::size_t>(triangles) * 12, GL_R32UI,
          sizeof(GLuint));
  maxTriangles_ = static_cast<int>(triangles);
  glClearNamedBufferData(count_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  int firstVertex = 0;
  for (const sim::Surface* surface : surfaces) {
    const gl::Texture corners = gl::Texture::view("indices", GL_R32UI, *surface->indices, sizeof(GLuint));
    const int room = verticesOf(*surface);
    const int maximum = maxTrianglesOf(*surface);
    kernels_.of({.deformed = surface->deform != nullptr, .counted = surface->arguments != nullptr})
        .dispatch(inRows(std::max(room, maximum)), {.surface = worldVertices(*surface),
                                                    .indices = corners,
                                                    .arguments = orNone(surface->arguments),
                                                    .vertexCount = room,
                                                    .firstVertex = firstVertex,
                                                    .triangleCount = maximum,
                                                    .rowOf = rowOf(*surface),
                                                    .places = places_,
                                                    .merged = indices_,
                                                    .count = count_});
    firstVertex += room;
  }
  gl::barrier();
}

}  // namespace simreel::draw
