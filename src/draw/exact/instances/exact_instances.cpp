#include "draw/exact/instances/exact_instances.hpp"

#include "base/error.hpp"
#include "draw/surface/surface_pass.hpp"

#include <algorithm>
#include <cstdint>

namespace simreel::draw {

namespace {

constexpr std::uint64_t lastId = 0xfffffff0;  // the last ones say ground, and nothing

/// Sprites of at most this radius are lit as squares, as the driver draws them.
constexpr float squarePixels = 1.6F;

bool isMesh(const sim::Instances& instances) {
  return instances.shape == sim::Instances::Shape::mesh;
}

/// First number after `count` more.
unsigned after(unsigned firstId, std::uint64_t count) {
  if (firstId + count > lastId)
    fail(ExitCode::device,
         "the exact rasterizer numbers {} triangles and balls of one picture, and these are {}; set "
         "\"rasterizer\" to \"driver\"",
         lastId, firstId + count);
  return static_cast<unsigned>(firstId + count);
}

}  // namespace

void ExactInstances::check(const sim::Drawables& drawables) {
  for (const sim::Instances& instances : drawables.instances) {
    if (isMesh(instances))
      fail(ExitCode::usage,
           "the exact rasterizer does not draw copies of a mesh yet; set \"rasterizer\" to \"driver\"");
  }
}

void ExactInstances::castShadows(const sim::Drawables& drawables, const Visibility& map) {
  std::vector<const sim::Instances*> casting;
  for (const sim::Instances& instances : drawables.instances)
    if (castsShadow(instances) && !isMesh(instances)) casting.push_back(&instances);
  ballShadows_.drawNearest(casting, map);
}

void ExactInstances::drawNearest(const sim::Drawables& drawables, const Visibility& picture) {
  balls_.clear();
  for (const sim::Instances& instances : drawables.instances)
    if (!instances.additive && !isMesh(instances)) balls_.push_back(&instances);
  ballRaster_.drawNearest(balls_, picture);
}

void ExactInstances::drawNumbers(unsigned firstId, const Visibility& picture,
                                 std::vector<unsigned>& firstIds) {
  ballIds_.clear();
  for (const sim::Instances* balls : balls_) {
    ballIds_.push_back(firstId);
    firstId = after(firstId, static_cast<std::uint64_t>(balls->capacity));
  }
  ballRaster_.drawNumbers(ballIds_, picture);
  firstIds.insert(firstIds.end(), ballIds_.begin(), ballIds_.end());
}

const gl::Program& ExactInstances::shading(const sim::Instances& instances) {
  const bool reflective = isReflective(*instances.material);
  const bool translucent = instances.material->translucency > 0;
  const char* path = "draw/exact/instances/shade_balls.comp";
  const std::string key = std::string(path) + (reflective ? " r" : "") + (translucent ? " t" : "");
  const auto found = programs_.find(key);
  if (found != programs_.end()) return found->second;
  gl::Defines defines = lighting_;
  if (reflective) defines.emplace_back("REFLECTIVE", "1");
  if (translucent) defines.emplace_back("TRANSLUCENT", "1");
  return programs_.emplace(key, gl::Program::compute(path, defines)).first->second;
}

void ExactInstances::shade(const ShadedTiles& tiles, int firstThing) {
  colors_.resize(std::max(colors_.size(), balls_.size()));
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const sim::Instances& balls = *balls_[i];
    const scene::Material& material = *balls.material;
    const gl::Program& shader = shading(balls);
    setInstance(shader, balls, shapes_.of(balls).radius(), minPixelsOf(balls));
    colors_[i].update(balls);
    colors_[i].set(shader, balls);
    shader.set("capacity", balls.capacity);
    shader.set("firstId", ballIds_[i]);
    shader.set("material", glm::vec3(material.roughness, material.metallic, material.translucency));
    shader.set("squarePixels", isSprite(balls) ? squarePixels : 0.0F);
    tiles.shade(firstThing + static_cast<int>(i), shader);
  }
}

bool ExactInstances::anyAdd(const sim::Drawables& drawables) {
  return std::any_of(drawables.instances.begin(), drawables.instances.end(),
                     [](const sim::Instances& instances) { return instances.additive; });
}

void ExactInstances::addLight(const sim::Drawables& drawables, const Visibility& picture) {
  if (!anyAdd(drawables)) return;
  std::vector<const sim::Instances*> glows;
  for (const sim::Instances& instances : drawables.instances)
    if (instances.additive && !isMesh(instances)) glows.push_back(&instances);
  glowRaster_.prepare(picture.size());
  glowRaster_.draw(glows, picture);
  glowRaster_.addTo(picture.size());
}

}  // namespace simreel::draw
