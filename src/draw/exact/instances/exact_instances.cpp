#include "draw/exact/instances/exact_instances.hpp"

#include "base/error.hpp"
#include "draw/surface/surface_pass.hpp"

#include <algorithm>
#include <cstdint>

namespace simreel::draw {

/// Kernel fields for the material and colours of instances.
struct ThingLook {
  InstanceLook colors;
  gl::Uniform<"material", glm::vec3> material;  ///< material values: roughness, metallic, translucency
};
struct InstanceVariant {
  ThingVariant thing;
  gl::Flag<"REFLECTIVE"> reflective;
  gl::Flag<"TRANSLUCENT"> translucent;
};

struct ShadeBalls {
  static constexpr auto file = "draw/exact/instances/shade_balls.comp";
  using Variant = InstanceVariant;
  TileFields tile;
  SceneLight light;
  InstanceSource source;
  ThingLook look;
  gl::Uniform<"squarePixels", float> squarePixels;
};

struct ShadeCopies {
  static constexpr auto file = "draw/exact/copies/shade_copies.comp";
  struct Variant {
    InstanceVariant instance;
    gl::Flag<"EDGES"> edges;
  };
  TileFields tile;
  SceneLight light;
  CopySource source;
  ThingLook look;
};

namespace {

constexpr std::uint64_t lastId = 0xfffffff0;  // max primitive id; larger ids mean the ground and empty
                                              // samples

/// Max radius (pixels) of sprites that are shaded as squares, like the small sprites of the driver's
/// rasterizer.
constexpr float squarePixels = 1.6F;

bool isMesh(const sim::Instances& instances) {
  return instances.shape == sim::Instances::Shape::mesh;
}

/// Returns the first free id after `count` more ids. Throws UserError(device) if there are not enough ids.
unsigned after(unsigned firstId, std::uint64_t count) {
  if (firstId + count > lastId)
    fail(ExitCode::device,
         "the picture has {} triangles and balls, but the exact rasterizer supports at most {}; reduce "
         "them, or "
         "set \"rasterizer\" to \"driver\"",
         firstId + count, lastId);
  return static_cast<unsigned>(firstId + count);
}

}  // namespace

ExactInstances::ExactInstances(int samples, Lighting lighting)
    : samples_(samples), lighting_(std::move(lighting)) {}

void ExactInstances::cast(const sim::Drawables& drawables, BallRaster& balls, CopyRaster& copies,
                          const Visibility& map, const MapPart& part) {
  std::vector<const sim::Instances*> castingBalls;
  std::vector<CopyRaster::Copies> castingCopies;
  for (const sim::Instances& instances : drawables.instances) {
    if (!castsShadow(instances)) continue;
    if (isMesh(instances))
      castingCopies.push_back(copiesOf(instances));
    else
      castingBalls.push_back(&instances);
  }
  balls.drawNearest(castingBalls, {}, map, part);
  copies.drawNearest(castingCopies, {}, map, part);
}

void ExactInstances::castShadows(const sim::Drawables& drawables, const Visibility& map,
                                 const MapPart& part) {
  cast(drawables, ballShadows_, copyShadows_, map, part);
}

void ExactInstances::castLampShadows(const sim::Drawables& drawables, const Visibility& maps,
                                     const MapPart& part) {
  cast(drawables, ballLampShadows_, copyLampShadows_, maps, part);
}

void ExactInstances::number(const sim::Drawables& drawables, unsigned firstId,
                            std::vector<unsigned>& firstIds) {
  balls_.clear();
  copies_.clear();
  for (const sim::Instances& instances : drawables.instances) {
    if (instances.additive) continue;
    if (isMesh(instances))
      copies_.push_back(copiesOf(instances));
    else
      balls_.push_back(&instances);
  }
  ballIds_.clear();
  copyIds_.clear();
  for (const sim::Instances* balls : balls_) {
    ballIds_.push_back(firstId);
    firstId = after(firstId, static_cast<std::uint64_t>(balls->capacity));
  }
  for (const CopyRaster::Copies& copies : copies_) {
    copyIds_.push_back(firstId);
    firstId = after(firstId, static_cast<std::uint64_t>(copies.instances->capacity) * copies.triangles());
  }
  firstIds.insert(firstIds.end(), ballIds_.begin(), ballIds_.end());
  firstIds.insert(firstIds.end(), copyIds_.begin(), copyIds_.end());
}

void ExactInstances::drawNearest(const Visibility& picture) {
  ballRaster_.drawNearest(balls_, ballIds_, picture);
  copyRaster_.drawNearest(copies_, copyIds_, picture);
}

void ExactInstances::drawIds(const Visibility& picture) {
  ballRaster_.drawIds(picture);
  copyRaster_.drawIds(picture);
}

std::vector<ExactInstances::Numbered> ExactInstances::numbered() const {
  std::vector<Numbered> all;
  for (std::size_t i = 0; i < balls_.size(); ++i) all.push_back({balls_[i], ballIds_[i], 1});
  for (std::size_t i = 0; i < copies_.size(); ++i)
    all.push_back({copies_[i].instances, copyIds_[i], std::max(copies_[i].triangles(), 1U)});
  return all;
}

void ExactInstances::describe(std::vector<DrawnThing>& things) const {
  const std::vector<Numbered> all = numbered();
  for (std::size_t i = 0; i < all.size(); ++i)
    things.push_back({objectName(*all[i].instances), i < balls_.size() ? "ball" : "instance",
                      all[i].firstId, all[i].each});
}

ThingLook ExactInstances::look(const sim::Instances& instances, std::size_t number) {
  const scene::Material& material = *instances.material;
  if (colors_.size() <= number) colors_.resize(number + 1);
  colors_[number].update(instances);
  return {.colors = colors_[number].look(instances),
          .material = glm::vec3(material.roughness, material.metallic, material.translucency)};
}

InstanceVariant ExactInstances::variant(const sim::Instances& instances) const {
  return {.thing = showing(lighting_.variant, shown_, mirrorsScene(instances.material->roughness)),
          .reflective = isReflective(*instances.material),
          .translucent = instances.material->translucency > 0};
}

bool ExactInstances::shades(const sim::Instances& instances) const {
  return shown_ != shownReflections || mirrorsScene(instances.material->roughness);
}

bool ExactInstances::anyMirrors(const sim::Drawables& drawables) {
  return std::any_of(drawables.instances.begin(), drawables.instances.end(),
                     [](const sim::Instances& instances) {
                       return !instances.additive && mirrorsScene(instances.material->roughness);
                     });
}

void ExactInstances::shade(const ShadedTiles& tiles, int firstObject, const SceneLight& light) {
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const sim::Instances& balls = *balls_[i];
    if (!shades(balls)) continue;
    const float radius = shapes_.of(balls).radius();
    tiles.shade(firstObject + static_cast<int>(i), ballShading_.of(variant(balls)),
                ShadeBalls{.tile = {},
                           .light = light,
                           .source = instanceSource(balls, radius, minPixelsOf(balls), ballIds_[i]),
                           .look = look(balls, i),
                           .squarePixels = isSprite(balls) ? squarePixels : 0.0F});
  }
  for (std::size_t i = 0; i < copies_.size(); ++i) {
    const sim::Instances& copies = *copies_[i].instances;
    if (!shades(copies)) continue;
    tiles.shade(firstObject + static_cast<int>(balls_.size() + i),
                copyShading_.of({.instance = variant(copies),
                                 .edges = shown_ == shownOverlay(scene::Overlay::wireframe)}),
                ShadeCopies{.tile = {},
                            .light = light,
                            .source = copyRaster_.source(copies_[i], copyIds_[i]),
                            .look = look(copies, balls_.size() + i)});
  }
}

bool ExactInstances::anyAdd(const sim::Drawables& drawables) {
  return std::any_of(drawables.instances.begin(), drawables.instances.end(),
                     [](const sim::Instances& instances) { return instances.additive; });
}

void ExactInstances::addLight(const sim::Drawables& drawables, const Visibility& picture,
                              const gl::Texture& light) {
  if (!anyAdd(drawables)) return;
  std::vector<const sim::Instances*> glows;
  std::vector<CopyRaster::Copies> copies;
  for (const sim::Instances& instances : drawables.instances) {
    if (!instances.additive) continue;
    if (isMesh(instances))
      copies.push_back(copiesOf(instances));
    else
      glows.push_back(&instances);
  }
  const bool hazy = lighting_.variant.shade.haze.defined;
  glowRaster_.setHazy(hazy);
  copyGlows_.setHazy(hazy);
  glowRaster_.prepare(picture.size());
  glowRaster_.draw(glows, picture);
  copyGlows_.addLight(copies, picture, glowRaster_.sums());
  glowRaster_.addTo(picture.size(), light);
}

}  // namespace simreel::draw
