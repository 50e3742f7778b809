#include "draw/lights/surface_cells.hpp"

#include "draw/draw_state.hpp"
#include "draw/surface_fields.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <span>

namespace simreel::draw {

struct SurfaceBox {
  static constexpr auto file = "draw/lights/surface_box.comp";
  struct Variant {
    gl::Flag<"DEFORMED"> deformed;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  PlacedSurface placed;
  gl::Uniform<"surface", int> surface;
  gl::Uniform<"vertexCount", int> vertexCount;
  gl::Uniform<"invocations", int> invocations;
  gl::Shared<"BoxBlock"> boxes;
};

struct ListCells {
  static constexpr auto file = "draw/lights/surface_cells.comp";
  gl::Ambient<"LampBlock"> lampBlock = {};
  gl::Ambient<"lampMembers"> lamps = {};
  gl::InOut<"BoxBlock"> boxes;
  gl::Out<"CellBlock"> cells;
  gl::InOut<"ArgumentBlock"> arguments;
  gl::Uniform<"surfaces", int> surfaces;
};

namespace {

constexpr std::size_t boxWords = 6;
constexpr std::size_t argumentWords = 5;  // number of words in the arguments of glDrawElementsIndirect

}  // namespace

SurfaceCells::SurfaceCells(int cells, const gl::Defines& lampDefines) : cells_(cells), list_(lampDefines) {}

void SurfaceCells::resize(std::size_t surfaces) {
  if (surfaces <= capacity_) return;
  capacity_ = surfaces;
  std::vector<unsigned> empty(boxWords * surfaces);
  for (std::size_t i = 0; i < empty.size(); ++i) empty[i] = i % boxWords < 3 ? 0xffffffffU : 0;
  boxes_ = gl::Buffer::of<unsigned>("boxes of surfaces", empty);
  cellView_ = {};
  cellNumbers_ =
      gl::Buffer("shadow maps of surfaces", surfaces * static_cast<std::size_t>(cells_) * sizeof(unsigned));
  cellView_ = gl::Texture::view("shadow maps of surfaces", GL_R32UI, cellNumbers_, sizeof(unsigned));
  arguments_ = gl::Buffer("shadow draws of surfaces", surfaces * argumentWords * sizeof(unsigned));
}

void SurfaceCells::growBox(const sim::Surface& surface, int number) {
  constexpr int maxInvocations = 1 << 14;
  constexpr int verticesEach = 32;
  const int invocations =
      std::clamp((surface.vertexCount + verticesEach - 1) / verticesEach, 1, maxInvocations);
  box_.of({.deformed = surface.deform != nullptr})
      .dispatch(invocations, {.placed = placed(surface),
                              .surface = number,
                              .vertexCount = surface.vertexCount,
                              .invocations = invocations,
                              .boxes = boxes_});
}

/// Copies the index counts of surfaces whose triangles are generated on the GPU.
void SurfaceCells::copyCounts(const std::vector<sim::Surface>& surfaces) const {
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (const gl::Buffer* counted = surfaces[i].arguments)
      glCopyNamedBufferSubData(counted->name(), arguments_.name(), 0,
                               static_cast<GLintptr>(i * argumentWords * sizeof(unsigned)),
                               sizeof(unsigned));
}

void SurfaceCells::find(const std::vector<sim::Surface>& surfaces) {
  if (surfaces.empty()) return;
  resize(surfaces.size());
  std::vector<unsigned> arguments;
  for (const sim::Surface& surface : surfaces)
    arguments.insert(arguments.end(), {static_cast<unsigned>(surface.indexCount), 0, 0, 0, 0});
  arguments_.write(0, std::as_bytes(std::span(arguments)));
  copyCounts(surfaces);
  for (std::size_t i = 0; i < surfaces.size(); ++i) growBox(surfaces[i], static_cast<int>(i));
  const int count = static_cast<int>(surfaces.size());
  list_.dispatch(count,
                 {.boxes = boxes_, .cells = cellNumbers_, .arguments = arguments_, .surfaces = count});
  gl::barrier(GL_COMMAND_BARRIER_BIT);
}

void SurfaceCells::draw(const gl::Program& program, std::size_t i) const {
  program.set("firstCell", static_cast<int>(i) * cells_);
  program.use();
  cellView_.bind(cellUnit);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, arguments_.name());
  // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes an offset for a pointer.
  const auto* offset = reinterpret_cast<const void*>(i * argumentWords * sizeof(unsigned));
  glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, offset);
}

}  // namespace simreel::draw
