#include "draw/exact/rays/ray_scene.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"
#include "draw/exact/rays/ray_count.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/surface_fields.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace simreel::draw {

struct GatherSurface {
  static constexpr auto file = "draw/exact/rays/gather.comp";
  struct Variant {
    WorldVariant surface;
    gl::Flag<"COUNTED"> counted;
    gl::Flag<"PALETTE"> palette;
    gl::Flag<"VERTEX_COLORS"> tinted;
    gl::Flag<"LAID"> laid;
    gl::Flag<"TRIPLANAR"> sides;
  };
  WorldVertices surface;
  gl::In<"indices"> indices;
  gl::In<"DrawArgumentBlock"> arguments;
  gl::In<"palette"> palette;
  gl::In<"vertexTints"> tints;
  gl::In<"uvs"> uvs;
  gl::Uniform<"perGrid", glm::vec2> perGrid;
  gl::Uniform<"modelScale", float> modelScale;
  gl::Uniform<"vertexCount", int> vertexCount;
  gl::Uniform<"firstVertex", int> firstVertex;
  gl::Uniform<"triangleCount", int> triangleCount;
  gl::Uniform<"firstTriangle", int> firstTriangle;
  gl::Uniform<"rowOf", glm::ivec2> rowOf;
  gl::Uniform<"owner", unsigned> owner;
  gl::Uniform<"color", glm::vec3> color;
  gl::Shared<"PlaceBlock"> places;
  gl::Shared<"WordBlock"> words;
  gl::Shared<"CornerBlock"> corners;
  gl::Shared<"LayBlock"> lays;
};

struct GatherCopies {
  static constexpr auto file = "draw/exact/rays/gather_copies.comp";
  CopySource source;
  InstanceLook look;
  gl::Uniform<"firstVertex", int> firstVertex;
  gl::Uniform<"firstTriangle", int> firstTriangle;
  gl::Uniform<"owner", unsigned> owner;
  gl::Shared<"PlaceBlock"> places;
  gl::Shared<"WordBlock"> words;
  gl::Shared<"CornerBlock"> corners;
};

struct GatherBalls {
  static constexpr auto file = "draw/exact/rays/gather_balls.comp";
  InstanceSource source;
  InstanceLook look;
  gl::Uniform<"firstBall", int> firstBall;
  gl::Uniform<"owner", float> owner;
  gl::Shared<"PlaceBlock"> places;
  gl::Shared<"LookBlock"> materials;
};

namespace {

constexpr float ballShapeRadius = 0.5F;  // radius of sprites and spheres of size 1

bool isCopies(const sim::Instances& instances) {
  return instances.shape == sim::Instances::Shape::mesh;
}

TraceRays raysOf(const gl::Texture& rays, const gl::Buffer& hits, int first, int count) {
  return {.solids = {},
          .trees = {},
          .bounds = {},
          .rays = rays,
          .firstRay = first,
          .rayCount = count,
          .hits = hits};
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
  constexpr std::int64_t maximum = 1 << 26;
  if (std::max({vertices, triangles, balls}) > maximum)
    fail(ExitCode::device,
         "render.quality \"high\": the picture has {} vertices, triangles or balls, but path tracing "
         "supports "
         "at most {} of each; set \"quality\" to \"standard\"",
         std::max({vertices, triangles, balls}), maximum);
  vertexCount_ = static_cast<int>(vertices);
  triangleCount_ = static_cast<int>(triangles);
  ballCount_ = static_cast<int>(balls);
  const auto size = [](int of, std::size_t bytes) { return static_cast<std::size_t>(of) * bytes; };
  reserve(places_, placeView_, "vertices that rays meet", size(vertexCount_, 16), GL_RGBA32F, 16);
  reserve(words_, wordView_, "looks of vertices that rays meet", size(vertexCount_, 16), GL_RGBA32UI, 16);
  const bool laid =
      std::any_of(drawables.surfaces.begin(), drawables.surfaces.end(), RayMaterials::isTextured);
  if (laid)
    reserve(lays_, layView_, "where things are laid on what rays meet", size(vertexCount_, 16), GL_RGBA32F,
            16);
  reserve(corners_, cornerView_, "corners that rays meet", size(triangleCount_, 12), GL_R32UI, 4);
  reserve(ballPlaces_, ballPlaceView_, "balls that rays meet", size(ballCount_, 16), GL_RGBA32F, 16);
  reserve(ballLookBuffer_, ballLookView_, "looks of balls that rays meet", size(ballCount_, 16), GL_RGBA32F,
          16);
}

void RayScene::gatherSurface(const sim::Surface& surface, int firstVertex, int firstTriangle,
                             unsigned owner) {
  const bool grid = surface.normals == nullptr, laid = RayMaterials::isTextured(surface);
  const gl::Texture indices = gl::Texture::view("indices", GL_R32UI, *surface.indices, sizeof(GLuint));
  gather_
      .of({.surface = worldVariant(surface),
           .counted = surface.arguments != nullptr,
           .palette = surface.palette != nullptr,
           .tinted = surface.colors != nullptr,
           .laid = laid,
           .sides = laid && RayMaterials::isTriplanar(surface)})
      .dispatch(inRows(std::max(verticesOf(surface), maxTrianglesOf(surface))),
                {.surface = worldVertices(surface),
                 .indices = indices,
                 .arguments = orNone(surface.arguments),
                 .palette = orNone(surface.palette),
                 .tints = orNone(surface.colors),
                 .uvs = orNone(surface.uvs),
                 .perGrid = grid ? 1.0F / glm::vec2(surface.grid - 1) : glm::vec2(0),
                 .modelScale = RayMaterials::scaleOf(surface),
                 .vertexCount = verticesOf(surface),
                 .firstVertex = firstVertex,
                 .triangleCount = maxTrianglesOf(surface),
                 .firstTriangle = firstTriangle,
                 .rowOf = rowOf(surface),
                 .owner = owner,
                 .color = surface.material->color,
                 .places = places_,
                 .words = words_,
                 .corners = corners_,
                 .lays = lays_});
}

void RayScene::gatherCopies(const CopyRaster::Copies& copies, InstanceColors& colors, int firstVertex,
                            int firstTriangle, unsigned owner) {
  if (!gatherCopies_) gatherCopies_ = gl::Kernel<GatherCopies>(gl::Defines());
  colors.update(*copies.instances);
  gatherCopies_.dispatch(inRows(copies.instances->capacity * static_cast<int>(copies.triangles())),
                         {.source = copyRaster_.source(copies, 0),
                          .look = colors.look(*copies.instances),
                          .firstVertex = firstVertex,
                          .firstTriangle = firstTriangle,
                          .owner = owner,
                          .places = places_,
                          .words = words_,
                          .corners = corners_});
}

void RayScene::gatherBalls(const sim::Instances& balls, InstanceColors& colors, int firstBall,
                           unsigned owner) {
  if (!gatherBalls_) gatherBalls_ = gl::Kernel<GatherBalls>(gl::Defines());
  colors.update(balls);
  gatherBalls_.dispatch(inRows(balls.capacity), {.source = instanceSource(balls, ballShapeRadius, 0, 0),
                                                 .look = colors.look(balls),
                                                 .firstBall = firstBall,
                                                 .owner = static_cast<float>(owner),
                                                 .places = ballPlaces_,
                                                 .materials = ballLookBuffer_});
}

/// Adds the surfaces whose material (not skin) emits light to the emitters.
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
                                    .materials = &looks_.view()};
  const Hierarchy::Solids balls{.count = ballCount_,
                                .places = &ballPlaceView_,
                                .ballLooks = &ballLookView_,
                                .materials = &looks_.view()};
  triangles_.growBounds(triangles, bounds_);
  balls_.growBounds(balls, bounds_);
  triangles_.build(triangles, bounds_);
  balls_.build(balls, bounds_);
}

RayFeatures RayScene::features() const {
  RayFeatures all{.triangles = triangles_.count() > 0, .balls = balls_.count() > 0, .ground = ground_};
  looks_.addTo(all);
  return all;
}

RayLookFields RayScene::lookFields() const {
  return {.materials = looks_.view(),
          .corners = cornerView_,
          .words = wordView_,
          .lays = layView_,
          .maps = looks_.mapTexels()};
}

SortedSolids RayScene::sorted() const {
  return {.solids = triangles_.sortedTexels(), .ids = triangles_.ids(), .balls = balls_.sortedTexels()};
}

FoundFields RayScene::found() const {
  return {.ballLooks = ballLookView_, .skinTexels = looks_.skinTexels()};
}

EmitterFields RayScene::emitters() const {
  return emitters_.fields(placeView_);
}

void RayScene::trace(TraceRays::Variant variant, TraceRays given, int count) {
  const RayFeatures all = features();
  variant.triangles = all.triangles;
  variant.balls = all.balls;
  variant.ground = all.ground;
  variant.laid = all.laid;
  variant.passages = all.passages;
  given.solids = sorted();
  given.trees = {.solidNodes = triangles_.nodeTexels(),
                 .ballNodes = balls_.nodeTexels(),
                 .solidCount = triangles_.count(),
                 .solidLeaves = triangles_.leaves(),
                 .ballCount = balls_.count(),
                 .ballLeaves = balls_.leaves()};
  given.materials = lookFields();
  given.bounds = bounds_;
  trace_.of(variant).dispatch(inRows(count), given);
}

void RayScene::traceListed(const gl::Texture& rays, const gl::Buffer& hits, int first,
                           const gl::Texture& list, int count) {
  if (RayCount* counted = RayCount::current()) counted->add(count);
  TraceRays given = raysOf(rays, hits, first, count);
  given.list = list;
  trace({.triangles = {}, .balls = {}, .goesOn = true}, given, count);
}

void RayScene::traceLight(const gl::Texture& rays, const gl::Buffer& hits, const gl::Texture& lists,
                          const gl::Buffer& counters, int maximum) {
  TraceRays given = raysOf(rays, hits, maximum, 0);
  given.list = lists;
  given.counts = counters;
  trace({.triangles = {}, .balls = {}, .anyHit = true, .listed = true}, given, 2 * maximum);
}

void RayScene::trace(const gl::Texture& rays, const gl::Buffer& hits, int first, int count) {
  if (RayCount* counted = RayCount::current()) counted->add(rays, first, count);
  trace({.triangles = {}, .balls = {}}, raysOf(rays, hits, first, count), count);
}

}  // namespace simreel::draw
