#include "draw/exact/rays/ray_scene.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"
#include "draw/exact/rays/bindings.hpp"
#include "draw/exact/rays/ray_count.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace simreel::draw {

namespace {

constexpr float ballShapeRadius = 0.5F;  // of sprites and spheres at size 1

bool isCopies(const sim::Instances& instances) {
  return instances.shape == sim::Instances::Shape::mesh;
}

}  // namespace

void RayScene::count(const sim::Drawables& drawables) {
  std::int64_t vertices = 0, triangles = 0, balls = 0;
  for (const sim::Surface& surface : drawables.surfaces) {
    vertices += verticesOf(surface);
    triangles += maxTrianglesOf(surface);
  }
  for (const sim::Instances& instances : drawables.instances) {
    if (instances.additive) continue;
    if (!isCopies(instances)) {
      balls += instances.capacity;
      continue;
    }
    const std::int64_t of = std::int64_t{instances.capacity} * copiesOf(instances).triangles();
    vertices += 3 * of;
    triangles += of;
  }
  constexpr std::int64_t most = 1 << 26;
  if (std::max({vertices, triangles, balls}) > most)
    fail(ExitCode::device,
         "render.quality \"high\": rays find their way among {} triangles or balls at most, and this "
         "picture "
         "has {}; set it to \"standard\"",
         most, std::max({vertices, triangles, balls}));
  vertexCount_ = static_cast<int>(vertices);
  triangleCount_ = static_cast<int>(triangles);
  ballCount_ = static_cast<int>(balls);
  const auto size = [](int of, std::size_t bytes) { return static_cast<std::size_t>(of) * bytes; };
  reserve(places_, placeView_, "vertices that rays meet", size(vertexCount_, 16), GL_RGBA32F, 16);
  reserve(words_, wordView_, "looks of vertices that rays meet", size(vertexCount_, 16), GL_RGBA32UI, 16);
  const bool laid = std::any_of(drawables.surfaces.begin(), drawables.surfaces.end(), RayLooks::isLaid);
  if (laid)
    reserve(lays_, layView_, "where things are laid on what rays meet", size(vertexCount_, 16), GL_RGBA32F,
            16);
  reserve(corners_, cornerView_, "corners that rays meet", size(triangleCount_, 12), GL_R32UI, 4);
  reserve(ballPlaces_, ballPlaceView_, "balls that rays meet", size(ballCount_, 16), GL_RGBA32F, 16);
  reserve(ballLookBuffer_, ballLookView_, "looks of balls that rays meet", size(ballCount_, 16), GL_RGBA32F,
          16);
}

const gl::Program& RayScene::gatherProgram(const sim::Surface& surface) {
  const bool grid = surface.normals == nullptr, deformed = surface.deform != nullptr;
  const bool counted = surface.arguments != nullptr, colored = surface.palette != nullptr;
  const bool laid = RayLooks::isLaid(surface), sides = laid && RayLooks::fromThreeSides(surface);
  const bool tinted = surface.colors != nullptr;
  const unsigned key = (tinted ? 64U : 0U) | (grid ? 1U : 0U) | (deformed ? 2U : 0U) | (counted ? 4U : 0U) |
                       (colored ? 8U : 0U) | (laid ? 16U : 0U) | (sides ? 32U : 0U);
  gl::Program& kernel = gatherPrograms_[key];
  if (!kernel) {
    gl::Defines defines;
    if (grid) defines.emplace_back("GRID", "1");
    if (deformed) defines.emplace_back("DEFORMED", "1");
    if (counted) defines.emplace_back("COUNTED", "1");
    if (colored) defines.emplace_back("PALETTE", "1");
    if (tinted) defines.emplace_back("VERTEX_COLORS", "1");
    if (laid) defines.emplace_back("LAID", "1");
    if (sides) defines.emplace_back("TRIPLANAR", "1");
    kernel = gl::Program::compute("draw/exact/rays/gather.comp", defines);
  }
  return kernel;
}

void RayScene::gatherSurface(const sim::Surface& surface, int firstVertex, int firstTriangle,
                             unsigned owner) {
  const bool grid = surface.normals == nullptr, counted = surface.arguments != nullptr;
  const gl::Program& kernel = gatherProgram(surface);
  if (RayLooks::isLaid(surface)) {
    lays_.bindStorage(outLayBinding);
    if (!grid && surface.uvs != nullptr) surface.uvs->bind(uvUnit);
    kernel.set("modelScale", RayLooks::scaleOf(surface));
    if (grid) kernel.set("perGrid", 1.0F / glm::vec2(surface.grid - 1));
  }
  const gl::Texture indices = gl::Texture::view("indices", GL_R32UI, *surface.indices, sizeof(GLuint));
  bindPositions(surface, kernel);
  if (!grid) surface.normals->bind(normalUnit);
  bindDeformation(surface);
  indices.bind(indexUnit);
  if (counted) surface.arguments->bindStorage(drawArgumentBinding);
  if (surface.palette != nullptr) surface.palette->bind(paletteUnit);
  if (surface.colors != nullptr) surface.colors->bind(paletteUnit);
  kernel.set("model", surface.model);
  kernel.set("grid", surface.grid);
  kernel.set("vertexCount", verticesOf(surface));
  kernel.set("firstVertex", firstVertex);
  kernel.set("triangleCount", maxTrianglesOf(surface));
  kernel.set("firstTriangle", firstTriangle);
  kernel.set("rowOf", rowOf(surface));
  kernel.set("owner", owner);
  kernel.set("color", surface.material->color);
  dispatchRows(kernel, std::max(verticesOf(surface), maxTrianglesOf(surface)));
}

void RayScene::gatherCopies(const CopyRaster::Copies& copies, InstanceColors& colors, int firstVertex,
                            int firstTriangle, unsigned owner) {
  if (!copyProgram_) copyProgram_ = gl::Program::compute("draw/exact/rays/gather_copies.comp");
  copyRaster_.set(copyProgram_, copies, 0);
  colors.update(*copies.instances);
  colors.set(copyProgram_, *copies.instances);
  copyProgram_.set("firstVertex", firstVertex);
  copyProgram_.set("firstTriangle", firstTriangle);
  copyProgram_.set("owner", owner);
  dispatchRows(copyProgram_, copies.instances->capacity * static_cast<int>(copies.triangles()));
}

void RayScene::gatherBalls(const sim::Instances& balls, InstanceColors& colors, int firstBall,
                           unsigned owner) {
  if (!ballProgram_) ballProgram_ = gl::Program::compute("draw/exact/rays/gather_balls.comp");
  setInstance(ballProgram_, balls, ballShapeRadius, 0);
  colors.update(balls);
  colors.set(ballProgram_, balls);
  ballProgram_.set("capacity", balls.capacity);
  ballProgram_.set("firstBall", firstBall);
  ballProgram_.set("owner", static_cast<float>(owner));
  ballPlaces_.bindStorage(outPlaceBinding);
  ballLookBuffer_.bindStorage(outWordBinding);
  dispatchRows(ballProgram_, balls.capacity);
}

/// Those of surfaces whose light of their own is the material's.
void RayScene::findEmitters(const sim::Drawables& drawables) {
  emitters_.begin();
  int triangle = 0;
  for (const sim::Surface& surface : drawables.surfaces) {
    const scene::Material& material = *surface.material;
    const scene::Finish& finish = material.finish;
    const int count = maxTrianglesOf(surface);
    if (!material.skin && finish.emits()) {
      const glm::dvec3 light = glm::dvec3(finish.emission) * static_cast<double>(finish.emissionStrength);
      emitters_.add(places_, corners_, triangle, count,
                    0.2126 * light.x + 0.7152 * light.y + 0.0722 * light.z);
    }
    triangle += count;
  }
  emitters_.finish();
}

void RayScene::build(const sim::Drawables& drawables) {
  count(drawables);
  looks_.begin();
  if (colors_.size() < drawables.instances.size()) colors_.resize(drawables.instances.size());
  places_.bindStorage(outPlaceBinding);
  words_.bindStorage(outWordBinding);
  corners_.bindStorage(outCornerBinding);
  int vertex = 0, triangle = 0, ball = 0;
  for (const sim::Surface& surface : drawables.surfaces) {
    gatherSurface(surface, vertex, triangle, looks_.add(surface));
    vertex += verticesOf(surface);
    triangle += maxTrianglesOf(surface);
  }
  for (std::size_t i = 0; i < drawables.instances.size(); ++i) {
    const sim::Instances& instances = drawables.instances[i];
    if (instances.additive || !isCopies(instances)) continue;
    const CopyRaster::Copies copies = copiesOf(instances);
    gatherCopies(copies, colors_[i], vertex, triangle, looks_.add(*instances.material));
    const int of = instances.capacity * static_cast<int>(copies.triangles());
    vertex += 3 * of;
    triangle += of;
  }
  for (std::size_t i = 0; i < drawables.instances.size(); ++i) {
    const sim::Instances& instances = drawables.instances[i];
    if (instances.additive || isCopies(instances)) continue;
    gatherBalls(instances, colors_[i], ball, looks_.add(*instances.material));
    ball += instances.capacity;
  }
  gl::barrier();
  looks_.finish();
  if (looks_.anyEmit()) findEmitters(drawables);
  constexpr std::array<GLuint, 8> none = {~0U, ~0U, ~0U, 0, 0, 0, 0, 0};
  gl::beforeWrites();
  bounds_.write(0, std::as_bytes(std::span(none)));
  const Hierarchy::Solids triangles{.count = triangleCount_,
                                    .places = &placeView_,
                                    .corners = &cornerView_,
                                    .words = &wordView_,
                                    .looks = &looks_.view()};
  const Hierarchy::Solids balls{
      .count = ballCount_, .places = &ballPlaceView_, .ballLooks = &ballLookView_, .looks = &looks_.view()};
  triangles_.growBounds(triangles, bounds_);
  balls_.growBounds(balls, bounds_);
  gl::barrier();
  triangles_.build(triangles, bounds_);
  balls_.build(balls, bounds_);
}

gl::Defines RayScene::defines() const {
  gl::Defines defines;
  if ((features() & 1U) != 0) defines.emplace_back("TRIANGLES", "1");
  if ((features() & 2U) != 0) defines.emplace_back("BALLS", "1");
  if ((features() & 4U) != 0) defines.emplace_back("GROUND", "1");
  for (auto& define : looks_.defines()) defines.push_back(std::move(define));
  return defines;
}

void RayScene::bind(const gl::Program& program) const {
  triangles_.bind(program);
  balls_.bind(program);
  bounds_.bindStorage(rayBoundsBinding);
  cornerView_.bind(solidCornerUnit);
  wordView_.bind(solidWordUnit);
  looks_.bind();
  if (looks_.anyEmit()) {
    emitters_.bind(program);
    placeView_.bind(solidPlaceUnit);
  }
  if (looks_.anyLaid()) layView_.bind(rayLayUnit);
  ballLookView_.bind(ballLookUnit);
}

gl::Program& RayScene::tracer(Way way) {
  gl::Program& kernel = tracePrograms_[features() << 2U | static_cast<unsigned>(way)];
  if (!kernel) {
    gl::Defines found = defines();
    if (way == Way::nearestListed) found.emplace_back("GOES_ON", "1");
    if (way == Way::light) {
      found.emplace_back("ANY_HIT", "1");
      found.emplace_back("LISTED", "1");
    }
    kernel = gl::Program::compute("draw/exact/rays/trace.comp", found);
  }
  bind(kernel);
  return kernel;
}

void RayScene::traceListed(const gl::Texture& rays, const gl::Buffer& hits, int first,
                           const gl::Texture& list, int count) {
  if (RayCount* counted = RayCount::current()) counted->add(count);
  const gl::Program& kernel = tracer(Way::nearestListed);
  rays.bind(rayUnit);
  list.bind(rayListUnit);
  hits.bindStorage(outHitBinding);
  kernel.set("firstRay", first);
  kernel.set("rayCount", count);
  dispatchRows(kernel, count);
}

void RayScene::traceLight(const gl::Texture& rays, const gl::Buffer& hits, const gl::Texture& lists,
                          const gl::Buffer& counters, int most) {
  const gl::Program& kernel = tracer(Way::light);
  rays.bind(rayUnit);
  lists.bind(rayListUnit);
  counters.bindStorage(outCountBinding);
  hits.bindStorage(outHitBinding);
  kernel.set("firstRay", most);
  dispatchRows(kernel, 2 * most);
}

void RayScene::trace(const gl::Texture& rays, const gl::Buffer& hits, int first, int count) {
  if (RayCount* counted = RayCount::current()) counted->add(rays, first, count);
  const gl::Program& kernel = tracer(Way::nearest);
  rays.bind(rayUnit);
  hits.bindStorage(outHitBinding);
  kernel.set("firstRay", first);
  kernel.set("rayCount", count);
  dispatchRows(kernel, count);
}

}  // namespace simreel::draw
