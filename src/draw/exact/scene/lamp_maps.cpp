#include "draw/exact/scene/lamp_maps.hpp"

#include "draw/exact/bindings.hpp"
#include "draw/exact/exact_view.hpp"
#include "draw/exact/scene/apart.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace simreel::draw {

namespace {

/// Returns the camera of one face of a lamp's maps (glsl/draw/lights/faces.glsl). x is the distance along
/// the face's axis, and y and z are the coordinates across it. A map of `side` texels shows the points
/// where scale |y| <= x and scale |z| <= x.
shader::ExactView faceView(const shader::Lamp& lamp, int face, int side, float scale) {
  const auto axis = [&](int k) {
    glm::vec3 unit(0);
    unit[(face / 2 + k) % 3] = 1;
    return unit;
  };
  const glm::vec3 along = (face & 1) != 0 ? -axis(0) : axis(0);
  const glm::vec3 right = axis(1);
  const glm::vec3 down = axis(2);
  const float half = 0.5F * static_cast<float>(side);
  shader::ExactView view{};
  view.eye = glm::vec4(glm::vec3(lamp.place), 0);
  view.across = glm::vec4(half * (along + scale * right), 0);
  view.down = glm::vec4(half * (along + scale * down), 0);
  view.forward = glm::vec4(along, 0);
  view.ray = glm::vec4(along - (right + down) / scale, 0);
  view.rayAcross = glm::vec4(right / (half * scale), 0);
  view.rayDown = glm::vec4(down / (half * scale), 0);
  view.size = glm::ivec2(side);
  view.rows = {0, side};
  view.near = lamp.sampling.x;
  view.nearOverFar = 0;
  return view;
}

}  // namespace

static_assert(shader::maxFaceViews >= shader::lampFaces * static_cast<int>(scene::maxShadowedLights));

LampMaps::LampMaps(const Lamps& lamps, bool sparing, bool together)
    : sparing_(sparing), together_(together), count_(lamps.order().shadowed) {
  if (!on()) return;
  keys_.emplace("the shadow maps of the lights", lamps.order().atlas, 1, false);
  // The clipped triangles of all faces need only one barrier, so clipping in advance pays on GPUs too.
  constexpr int fans = 1 << 19;
  raster_.emplace(TriangleRaster::Into::lampMap, 1, smallTriangle(), fans, mediumTriangle());
  mesh_.emplace();
  lists_.emplace(lamps.shadowDefines());
  const auto alignment = static_cast<std::size_t>(gl::limits().uniformAlignment);
  viewStride_ = (sizeof(shader::ExactView) + alignment - 1) / alignment * alignment;
  views_ =
      gl::Buffer("views of the lamps", static_cast<std::size_t>(count_ * shader::lampFaces) * viewStride_);
  allViews_ = gl::Buffer("views of the lamps", shader::maxFaceViews * sizeof(shader::ExactView));
}

void LampMaps::draw(const sim::Drawables& drawables, const Lamps& lamps, ExactInstances& instances,
                    TransparentSurfaces* transparent) {
  std::vector<const sim::Surface*> casting;
  for (const sim::Surface& surface : drawables.surfaces)
    if (castsShadow(surface)) casting.push_back(&surface);
  std::vector<std::byte> bytes(views_.bytes());
  std::vector<shader::ExactView> views;
  const LampOrder& order = lamps.order();
  for (int i = 0; i < count_ * shader::lampFaces; ++i) {
    const auto lamp = static_cast<std::size_t>(i / shader::lampFaces);
    const int side = order.lights[lamp]->shadowSize;
    shader::ExactView view =
        faceView(lamps.values()[lamp], i % shader::lampFaces, side, lamps.values()[lamp].maps.w);
    view.eye.w = static_cast<float>(order.rows[lamp]);
    view.across.w = static_cast<float>(i % shader::lampFaces * side);
    views.push_back(view);
    const auto from = std::as_bytes(std::span(&view, 1));
    std::copy(from.begin(), from.end(), bytes.begin() + static_cast<std::ptrdiff_t>(i * viewStride_));
  }
  views_.write(0, bytes);
  allViews_.write(0, std::as_bytes(std::span(views)));
  keys_->clear();
  const int all = count_ * shader::lampFaces;
  std::vector<MapFace> faces;
  for (int i = 0; i < all; ++i) {
    const auto lamp = static_cast<std::size_t>(i / shader::lampFaces);
    const int side = order.lights[lamp]->shadowSize;
    // The offset is 0, because the receivers' planes are compared
    // (glsl/draw/exact/shadows/shadow_filter.glsl).
    faces.push_back({.views = &views_,
                     .view = static_cast<std::size_t>(i) * viewStride_,
                     .part = {.side = side,
                              .firstKey = order.rows[lamp] * order.atlas.x + i % shader::lampFaces * side,
                              .keyStride = order.atlas.x}});
  }
  if (!casting.empty()) drawMesh(*raster_, casting, faces, together_);
  const std::vector<sim::Surface> none;
  for (const sim::Surface& surface : transparent != nullptr ? transparent->casting() : none) {
    if (!holeRaster_) holeRaster_.emplace(TriangleRaster::ofFragments(TriangleRaster::Into::lampMap, 1));
    holeRaster_->tellFragments(transparent->holesOf(&surface));
    drawMesh(*holeRaster_, {&surface}, faces, false);
  }
  for (const MapFace& face : faces) {
    views_.bindUniform(viewBinding, face.view, sizeof(shader::ExactView));
    instances.castLampShadows(drawables, *keys_, face.part);
  }
}

void LampMaps::drawMesh(TriangleRaster& raster, const std::vector<const sim::Surface*>& casting,
                        const std::vector<MapFace>& faces, bool together) {
  mesh_->merge(casting);
  if (mesh_->maxTriangles() == 0) return;
  const int all = static_cast<int>(faces.size());
  const int atOnce = FaceLists::facesAtOnce(mesh_->maxTriangles());
  for (int first = 0; first < all; first += atOnce) {
    const int some = std::min(atOnce, all - first);
    const TriangleLists& lists =
        sparing_ ? lists_->find(*mesh_, first, some) : lists_->all(*mesh_, mesh_->maxTriangles(), some);
    const std::vector<MapFace> shown(faces.begin() + first, faces.begin() + first + some);
    if (together)
      raster.number(lists, shown, allViews_, first);
    else
      raster.number(lists, shown);
    raster.draw(*keys_);
  }
}

}  // namespace simreel::draw
