#include "draw/lights/lamp_shadows.hpp"

#include "base/error.hpp"
#include "draw/surface_fields.hpp"
#include "gl/context.hpp"
#include "gl/kernel/give.hpp"
#include "gl/limits.hpp"
#include "sim/grid/sheet_mesh.hpp"

#include <algorithm>

namespace simreel::draw {

namespace {

constexpr const char* surfaceVertices = "draw/lights/lamp_surface.vert";
constexpr const char* fragments = "draw/surface/shadow.frag";
constexpr GLenum clipSides = 4;  // number of gl_ClipDistance values in glsl/draw/lights/face_clip.glsl

gl::Texture makeMaps(glm::ivec2 size) {
  const int max = gl::limits().textureSize;
  if (size.x > max || size.y > max)
    fail(ExitCode::device,
         "the shadow maps of the lights need {}x{} texels, this device allows {}x{} (GL_MAX_TEXTURE_SIZE); "
         "lower their \"shadowSize\"",
         size.x, size.y, max, max);
  gl::Texture maps = gl::Texture::image("shadow maps of lamps", GL_DEPTH_COMPONENT32F, size.x, size.y);
  maps.wrap(GL_CLAMP_TO_EDGE);
  glTextureParameteri(maps.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTextureParameteri(maps.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  return maps;
}

void clip(bool on) {
  for (GLenum side = 0; side < clipSides; ++side)
    on ? glEnable(GL_CLIP_DISTANCE0 + side) : glDisable(GL_CLIP_DISTANCE0 + side);
}

}  // namespace

LampShadows::LampShadows(const Lamps& lamps)
    : count_(lamps.order().shadowed), defines_(lamps.shadowDefines()) {
  if (!on()) return;
  for (const scene::Light* light : lamps.order().lights)
    if (light->shadow) softness_ = std::max(softness_, light->shadowSoftness);
  surface_ = gl::Program::graphics(surfaceVertices, fragments, defines_);
  cells_ = std::make_unique<SurfaceCells>(shader::lampFaces * count_, defines_);
  if (gl::memoryPath() == gl::MemoryPath::storage)
    surface_.checkUniformBlock("LampBlock", static_cast<std::size_t>(count_) * sizeof(shader::Lamp));
  maps_ = makeMaps(lamps.order().atlas);
  target_ = gl::Framebuffer("shadow maps of lamps", nullptr, &maps_);
}

void LampShadows::draw(const sim::Drawables& drawables, const std::function<void(int cells)>& drawMore) {
  constexpr GLfloat farthest = 1;
  cells_->find(drawables.surfaces);
  DrawState{.depthTest = true, .cullBack = false, .depthOffset = true}.set();
  // As for the sun, a shadow filter of r texels reads depths up to r + 1 texels away along a slope.
  glPolygonOffset(1.5F + softness_, 4.0F);
  glClearNamedFramebufferfv(target_.name(), GL_DEPTH, 0, &farthest);
  target_.bind();
  clip(true);
  for (std::size_t i = 0; i < drawables.surfaces.size(); ++i) {
    const sim::Surface& surface = drawables.surfaces[i];
    if (!castsShadow(surface)) continue;
    const gl::Program& shader = programOf(surface);
    gl::give(shader, placed(surface));
    vertices_.bind(surface.rowIndices > 0 ? allIndices(surface.grid) : *surface.indices);
    cells_->draw(shader, i);
  }
  drawMore(shader::lampFaces * count_);
  clip(false);
}

/// Returns indices of all triangles of a grid, because one indirect draw must cover the whole grid.
const gl::Buffer& LampShadows::allIndices(glm::ivec2 grid) {
  gl::Buffer& indices = indices_[{grid.x, grid.y}];
  if (indices.name() == 0) indices = gl::Buffer::of<unsigned>("indices of a grid", sim::gridIndices(grid));
  return indices;
}

const gl::Program& LampShadows::programOf(const sim::Surface& surface) const {
  if (surface.deform == nullptr) return surface_;
  if (!deformed_) {
    gl::Defines defines = defines_;
    defines.emplace_back("DEFORMED", "1");
    deformed_ = gl::Program::graphics(surfaceVertices, fragments, defines);
  }
  return deformed_;
}

void LampShadows::bind() const {
  if (on()) maps_.bind(lampShadowUnit);
}

}  // namespace simreel::draw
