#include "draw/exact/motion/motion.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

void Motion::Elements::makeRoom(int count) {
  const std::size_t bytes = static_cast<std::size_t>(count) * sizeof(glm::vec4);
  reserve(first, firstView, "places between frames", bytes, GL_RGBA32F, sizeof(glm::vec4));
  reserve(second, secondView, "directions between frames", bytes, GL_RGBA32F, sizeof(glm::vec4));
}

void Motion::Elements::bindOutput() const {
  first.bindStorage(outVertexBinding);
  second.bindStorage(outNormalBinding);
}

const gl::Program& Motion::program(const std::string& name, const gl::Defines& defines) {
  std::string key = name;
  for (const auto& define : defines) key += " " + define.first;
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  gl::Defines all = defines;
  if (fast_) all.emplace_back("FAST_NUMERICS", "1");
  return programs_.emplace(key, gl::Program::compute("draw/exact/motion/" + name, all)).first->second;
}

void Motion::toWorld(const sim::Surface& surface, const Elements& into) {
  gl::Defines defines;
  if (surface.normals == nullptr) defines.emplace_back("GRID", "1");
  if (surface.deform != nullptr) defines.emplace_back("DEFORMED", "1");
  if (surface.palette != nullptr) defines.emplace_back("PALETTE", "1");
  const gl::Program& kernel = program("world_vertices.comp", defines);
  bindPositions(surface, kernel);
  if (surface.normals != nullptr) surface.normals->bind(normalUnit);
  bindDeformation(surface);
  into.bindOutput();
  kernel.set("model", surface.model);
  kernel.set("grid", surface.grid);
  kernel.set("vertexCount", verticesOf(surface));
  dispatchRows(kernel, verticesOf(surface));
}

void Motion::copy(const sim::Instances& instances, const Elements& into) {
  const gl::Program& kernel = program("keep_elements.comp");
  instances.positions->bind(positionUnit);
  instances.velocities->bind(velocityUnit);
  into.bindOutput();
  kernel.set("elementCount", instances.capacity);
  dispatchRows(kernel, instances.capacity);
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
    moving.jumped = surface.jumped;
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
  lagging_ = before.lagging;
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
    moving.jump = same ? jumpAt(moving.jumped, surface.jumped) : std::nullopt;
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
  const gl::Program& kernel = program("between_vertices.comp");
  moving.before.firstView.bind(positionUnit);
  moving.before.secondView.bind(normalUnit);
  moving.now.firstView.bind(vertexUnit);
  moving.now.secondView.bind(ownerUnit);
  moving.shown.bindOutput();
  kernel.set("part", part);
  kernel.set("vertexCount", moving.count);
  dispatchRows(kernel, moving.count);
  surface.positions = &moving.shown.firstView;
  if (surface.normals != nullptr) surface.normals = &moving.shown.secondView;
  surface.heights = nullptr;
  surface.deform = nullptr;
  surface.trail = nullptr;
  surface.model = glm::mat4(1.0F);
  surface.still = 0;
}

void Motion::place(sim::Instances& instances, Moving& moving, float part) {
  const gl::Program& kernel = program("between_elements.comp");
  moving.before.firstView.bind(positionUnit);
  moving.before.secondView.bind(velocityUnit);
  instances.positions->bind(vertexUnit);
  instances.velocities->bind(ownerUnit);
  moving.shown.bindOutput();
  kernel.set("part", part);
  kernel.set("seconds", static_cast<float>(seconds_));
  kernel.set("elementCount", moving.count);
  dispatchRows(kernel, moving.count);
  instances.positions = &moving.shown.firstView;
  instances.velocities = &moving.shown.secondView;
}

Motion::Way Motion::wayOf(std::size_t surface) const {
  const Moving& moving = surfaces_.at(surface);
  if (!moving.moves || moving.jump) return {};
  Way way{moving.before.first.readAll<glm::vec4>(), moving.now.first.readAll<glm::vec4>()};
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
  camera.lagging = drawables_->lagging;
  camera.paths = drawables_->paths;
  for (std::size_t i = 0; i < std::min(places_.size(), camera.places.size()); ++i) {
    sim::Place& place = camera.places[i];
    const std::optional<float> jump = jumpAt(places_[i].jumped, place.jumped);
    if (!jump)
      place.middle = glm::mix(places_[i].middle, place.middle, part);
    else if (part < *jump)
      place.middle = places_[i].middle;
  }
  for (std::size_t i = 0; i < std::min(lagging_.size(), camera.lagging.size()); ++i)
    camera.lagging[i] = glm::mix(lagging_[i], camera.lagging[i], part);
  return camera;
}

const sim::Drawables& Motion::between(float part) {
  SIMREEL_CHECK(drawables_ != nullptr);
  shown_ = *drawables_;
  gl::barrier();  // the moment before may still be drawn
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    if (Moving& moving = surfaces_[i]; moving.moves && (!moving.jump || part < *moving.jump))
      place(shown_.surfaces[i], moving, moving.jump ? 0 : part);
  for (std::size_t i = 0; i < instances_.size(); ++i)
    if (instances_[i].moves) place(shown_.instances[i], instances_[i], part);
  const sim::Drawables camera = cameraAt(part);
  shown_.places = camera.places;
  shown_.lagging = camera.lagging;
  gl::barrier();
  return shown_;
}

}  // namespace simreel::draw
