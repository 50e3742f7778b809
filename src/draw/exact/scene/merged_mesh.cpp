#include "draw/exact/scene/merged_mesh.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <cstdint>

namespace simreel::draw {

MergedMesh::MergedMesh() : count_("merged indices", 4 * sizeof(GLuint)) {}

const gl::Program& MergedMesh::program(bool deformed, bool counted) {
  const std::pair<bool, bool> key{deformed, counted};
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  gl::Defines defines;
  if (deformed) defines.emplace_back("DEFORMED", "1");
  if (counted) defines.emplace_back("COUNTED", "1");
  return programs_.emplace(key, gl::Program::compute("draw/exact/shadows/merge_mesh.comp", defines))
      .first->second;
}

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
         "the exact rasterizer draws {} triangles around lamps, and these are more; set \"rasterizer\" to "
         "\"driver\"",
         INT32_MAX / 3);
  reserve(places_, placesView_, "places in the world", static_cast<std::size_t>(vertices) * 16, GL_RGBA32F,
          16);
  reserve(indices_, indicesView_, "merged triangles", static_cast<std::size_t>(triangles) * 12, GL_R32UI,
          sizeof(GLuint));
  maxTriangles_ = static_cast<int>(triangles);
  glClearNamedBufferData(count_.name(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &zero);
  places_.bindStorage(outVertexBinding);
  indices_.bindStorage(largeBinding);
  count_.bindStorage(counterBinding);
  int firstVertex = 0;
  for (const sim::Surface* surface : surfaces) {
    const gl::Program& kernel = program(surface->deform != nullptr, surface->arguments != nullptr);
    const gl::Texture corners = gl::Texture::view("indices", GL_R32UI, *surface->indices, sizeof(GLuint));
    bindPositions(*surface, kernel);
    if (surface->normals != nullptr) surface->normals->bind(normalUnit);
    bindDeformation(*surface);
    corners.bind(indexUnit);
    if (surface->arguments != nullptr) surface->arguments->bindStorage(drawArgumentBinding);
    const int room = verticesOf(*surface);
    const int most = maxTrianglesOf(*surface);
    kernel.set("model", surface->model);
    kernel.set("vertexCount", room);
    kernel.set("firstVertex", firstVertex);
    kernel.set("triangleCount", most);
    kernel.set("rowOf", rowOf(*surface));
    dispatchRows(kernel, std::max(room, most));
    firstVertex += room;
  }
  gl::barrier();
}

}  // namespace simreel::draw
