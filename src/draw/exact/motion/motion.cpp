#include "draw/exact/motion/motion.hpp"

#include "base/error.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/exact/visibility.hpp"
#include "draw/surface_fields.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

struct WorldVertexKernel {
  static constexpr auto file = "draw/exact/motion/world_vertices.comp";
  struct Variant {
    WorldVariant surface;
    gl::Flag<"PALETTE"> palette;
  };
  WorldVertices surface;
  gl::Uniform<"vertexCount", int> vertexCount;
  gl::Out<"PlaceBlock"> places;
  gl::Out<"NormalBlock"> directions;
};

struct CopyElements {
  static constexpr auto file = "draw/exact/motion/keep_elements.comp";
  gl::In<"positions"> positions;
  gl::In<"velocities"> velocities;
  gl::Uniform<"elementCount", int> elementCount;
  gl::Out<"PlaceBlock"> places;
  gl::Out<"VelocityBlock"> velocitiesOut;
};

struct BetweenVertices {
  static constexpr auto file = "draw/exact/motion/between_vertices.comp";
  gl::In<"placesBefore"> placesBefore;
  gl::In<"normalsBefore"> normalsBefore;
  gl::In<"placesNow"> placesNow;
  gl::In<"normalsNow"> normalsNow;
  gl::Uniform<"part", float> part;
  gl::Uniform<"vertexCount", int> vertexCount;
  gl::Out<"PlaceBlock"> places;
  gl::Out<"NormalBlock"> directions;
};

struct BetweenElements {
  static constexpr auto file = "draw/exact/motion/between_elements.comp";
  gl::In<"placesBefore"> placesBefore;
  gl::In<"velocitiesBefore"> velocitiesBefore;
  gl::In<"placesNow"> placesNow;
  gl::In<"velocitiesNow"> velocitiesNow;
  gl::Uniform<"part", float> part;
  gl::Uniform<"seconds", float> seconds;
  gl::Uniform<"elementCount", int> elementCount;
  gl::Out<"PlaceBlock"> places;
  gl::Out<"VelocityBlock"> velocities;
};

namespace {

gl::Defines arithmetic(bool fast) {
  return fast ? gl::Defines{{"FAST_NUMERICS", "1"}} : gl::Defines();
}

}  // namespace

Motion::Motion(bool fast)
    : worldVertices_(arithmetic(fast)),
      copy_(gl::Defines()),
      betweenVertices_(arithmetic(fast)),
      betweenElements_(arithmetic(fast)) {}

void Motion::Elements::makeRoom(int count) {
  const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(glm::vec4);
  reserve(first, firstView, "places between frames", bytes, GL_RGBA32F, sizeof(glm::vec4));
  reserve(second, secondView, "directions between frames", bytes, GL_RGBA32F, sizeof(glm::vec4));
}

void Motion::toWorld(const sim::Surface& surface, const Elements& into) {
  worldVertices_.of({.surface = worldVariant(surface), .palette = surface.palette != nullptr})
      .dispatch(inRows(verticesOf(surface)), {.surface = worldVertices(surface),
                                              .vertexCount = verticesOf(surface),
                                              .places = into.first,
                                              .directions = into.second});
}

void Motion::copy(const sim::Instances& instances, const Elements& into) {
  copy_.dispatch(inRows(instances.capacity), {.positions = *instances.positions,
                                              .velocities = *instances.velocities,
                                              .elementCount = instances.capacity,
                                              .places = into.first,
                                              .velocitiesOut = into.second});
}

void Motion::keep(const sim::Drawables& before) {
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  surfaces_.resize(before.surfaces.size());
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const sim::Surface& surface = before.surfaces[i];
    Moving& moving = surfaces_[i];
    moving.object = objectName(surface);
    moving.count = surface.arguments != nullptr ? 0 : verticesOf(surface);
    moving.indices = surface.indexCount;
    moving.still = surface.still;
    moving.model = surface.model;
    moving.lastJumpSeconds = surface.lastJumpSeconds;
    if (moving.count == 0) continue;
    moving.before.makeRoom(moving.count);
    toWorld(surface, moving.before);
  }
  instances_.resize(before.instances.size());
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const sim::Instances& instances = before.instances[i];
    Moving& moving = instances_[i];
    moving.object = objectName(instances);
    moving.count = instances.capacity;
    if (moving.count == 0) continue;
    moving.before.makeRoom(moving.count);
    copy(instances, moving.before);
  }
  places_ = before.places;
  dampedCamera_ = before.dampedCamera;
  gl::barrier();
}

std::optional<float> Motion::jumpAt(double before, double now) const {
  if (now == before) return std::nullopt;
  return static_cast<float>(1 - (at_ - now) / seconds_);
}

void Motion::begin(const sim::Drawables& now, double seconds, double at) {
  drawables_ = &now;
  seconds_ = seconds;
  at_ = at;
  surfaces_.resize(now.surfaces.size());
  instances_.resize(now.instances.size());
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const sim::Surface& surface = now.surfaces[i];
    Moving& moving = surfaces_[i];
    const bool same = moving.count > 0 && moving.object == objectName(surface) &&
                      surface.arguments == nullptr && moving.count == verticesOf(surface) &&
                      moving.indices == surface.indexCount;
    const bool stays = surface.still != 0 && surface.still == moving.still && surface.model == moving.model;
    moving.moves = same && !stays;
    moving.jump = same ? jumpAt(moving.lastJumpSeconds, surface.lastJumpSeconds) : std::nullopt;
    if (!moving.moves) continue;
    moving.now.makeRoom(moving.count);
    moving.shown.makeRoom(moving.count);
    toWorld(surface, moving.now);
  }
  for (std::size_t i = 0; i < instances_.size(); ++i) {
    const sim::Instances& instances = now.instances[i];
    Moving& moving = instances_[i];
    moving.moves =
        moving.count > 0 && moving.object == objectName(instances) && moving.count == instances.capacity;
    if (moving.moves) moving.shown.makeRoom(moving.count);
  }
  gl::barrier();
}

void Motion::place(sim::Surface& surface, Moving& moving, float part) {
  betweenVertices_.dispatch(inRows(moving.count), {.placesBefore = moving.before.firstView,
                                                   .normalsBefore = moving.before.secondView,
                                                   .placesNow = moving.now.firstView,
                                                   .normalsNow = moving.now.secondView,
                                                   .part = part,
                                                   .vertexCount = moving.count,
                                                   .places = moving.shown.first,
                                                   .directions = moving.shown.second});
  surface.positions = &moving.shown.firstView;
  if (surface.normals != nullptr) surface.normals = &moving.shown.secondView;
  surface.heights = nullptr;
  surface.deform = nullptr;
  surface.trail = nullptr;
  surface.model = glm::mat4(1.0F);
  surface.still = 0;
}

void Motion::place(sim::Instances& instances, Moving& moving, float part) {
  betweenElements_.dispatch(inRows(moving.count), {.placesBefore = moving.before.firstView,
                                                   .velocitiesBefore = moving.before.secondView,
                                                   .placesNow = *instances.positions,
                                                   .velocitiesNow = *instances.velocities,
                                                   .part = part,
                                                   .seconds = static_cast<float>(seconds_),
                                                   .elementCount = moving.count,
                                                   .places = moving.shown.first,
                                                   .velocities = moving.shown.second});
  instances.positions = &moving.shown.firstView;
  instances.velocities = &moving.shown.secondView;
}

Motion::Displacement Motion::displacementOf(std::size_t surface) const {
  const Moving& moving = surfaces_.at(surface);
  if (!moving.moves || moving.jump) return {};
  Displacement way{moving.before.first.readAll<glm::vec4>(), moving.now.first.readAll<glm::vec4>()};
  for (auto* places : {&way.before, &way.now}) places->resize(static_cast<std::size_t>(moving.count));
  return way;
}

std::vector<glm::vec4> Motion::velocitiesOf(std::size_t number) {
  SIMREEL_CHECK(drawables_ != nullptr);
  const sim::Instances& instances = drawables_->instances.at(number);
  if (instances.capacity == 0) return {};
  copied_.makeRoom(instances.capacity);
  copy(instances, copied_);
  std::vector<glm::vec4> velocities = copied_.second.readAll<glm::vec4>();
  velocities.resize(static_cast<std::size_t>(instances.capacity));
  return velocities;
}

sim::Drawables Motion::cameraAt(float part) const {
  SIMREEL_CHECK(drawables_ != nullptr);
  sim::Drawables camera;
  camera.places = drawables_->places;
  camera.dampedCamera = drawables_->dampedCamera;
  camera.paths = drawables_->paths;
  for (std::size_t i = 0; i < std::min(places_.size(), camera.places.size()); ++i) {
    sim::Place& place = camera.places[i];
    const std::optional<float> jump = jumpAt(places_[i].lastJumpSeconds, place.lastJumpSeconds);
    if (!jump)
      place.middle = glm::mix(places_[i].middle, place.middle, part);
    else if (part < *jump)
      place.middle = places_[i].middle;
  }
  for (std::size_t i = 0; i < std::min(dampedCamera_.size(), camera.dampedCamera.size()); ++i)
    camera.dampedCamera[i] = glm::mix(dampedCamera_[i], camera.dampedCamera[i], part);
  return camera;
}

const sim::Drawables& Motion::between(float part) {
  SIMREEL_CHECK(drawables_ != nullptr);
  shown_ = *drawables_;
  gl::barrier();  // The following writes must wait for the draws of the previous moment.
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (Moving& moving = surfaces_[i]; moving.moves && (!moving.jump || part < *moving.jump))
      place(shown_.surfaces[i], moving, moving.jump ? 0 : part);
  for (std::size_t i = 0; i < instances_.size(); ++i)
    if (instances_[i].moves) place(shown_.instances[i], instances_[i], part);
  const sim::Drawables camera = cameraAt(part);
  shown_.places = camera.places;
  shown_.dampedCamera = camera.dampedCamera;
  gl::barrier();
  return shown_;
}

}  // namespace simreel::draw
