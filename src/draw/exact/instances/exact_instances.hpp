#pragma once
#include "draw/exact/instances/ball_raster.hpp"
#include "draw/exact/instances/copy_raster.hpp"
#include "draw/exact/instances/glow_raster.hpp"
#include "draw/exact/passes.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/instances/instance_values.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

namespace simreel::draw {

struct ThingLook;
struct InstanceVariant;
struct ShadeBalls;
struct ShadeCopies;

/// Draws instances with kernels in exact arithmetic. The primitive ids of opaque instances follow the ids
/// of the surfaces. The id of an instance is the draw's first id plus the index of the instance; for
/// meshes, the index is multiplied by the triangle count.
class ExactInstances {
 public:
  ExactInstances(int samples, Lighting lighting);

  /// Sets the lighting variant that later shade() calls use. The lights stay the same.
  void light(const ThingVariant& variant) { lighting_.variant = variant; }
  /// Selects the layer that shade() computes; see SurfaceShading::selectLayer().
  void selectLayer(int layer) { shown_ = layer; }
  /// True if any opaque instances reflect the scene.
  [[nodiscard]] static bool anyMirrors(const sim::Drawables& drawables);
  /// Extends the bounds of the sun's shadow map; see ShadowPass::fit().
  void growBounds(const sim::Drawables& drawables, const gl::Buffer& bounds) {
    bounds_.grow(drawables, shapes_, bounds);
  }
  /// Draws into the sun's shadow map, which may already contain other objects. The map's transform must be
  /// bound.
  void castShadows(const sim::Drawables& drawables, const Visibility& map, const MapPart& part);
  /// Draws into one lamp map, whose view must be bound.
  void castLampShadows(const sim::Drawables& drawables, const Visibility& maps, const MapPart& part);
  /// Assigns primitive ids to opaque instances, starting at `firstId`, and appends the first id of each
  /// draw to `firstIds`. Throws UserError(device) if there are not enough ids.
  void number(const sim::Drawables& drawables, unsigned firstId, std::vector<unsigned>& firstIds);
  /// Writes the depth keys. Must run before any object writes ids.
  void drawNearest(const Visibility& picture);
  /// Writes the ids. Call after all objects have written their keys.
  void drawIds(const Visibility& picture);
  /// Appends the drawn objects with their id ranges to `things`.
  void describe(std::vector<DrawnThing>& things) const;
  struct Numbered {
    const sim::Instances* instances;
    unsigned firstId, each;  ///< firstId: id of the first instance; each: number of ids per instance
  };
  [[nodiscard]] std::vector<Numbered> numbered() const;
  /// Adds the light of opaque instances. The draws have the object indices firstObject, firstObject + 1,
  /// ... in the tile lists.
  void shade(const ShadedTiles& tiles, int firstObject, const SceneLight& light);
  /// True if any instances are glows, which add light. The ground must then also be written into the depth
  /// keys.
  [[nodiscard]] static bool anyAdd(const sim::Drawables& drawables);
  /// Adds the light of glows in front of the visible surfaces to `light`.
  void addLight(const sim::Drawables& drawables, const Visibility& picture, const gl::Texture& light);

 private:
  void cast(const sim::Drawables& drawables, BallRaster& balls, CopyRaster& copies, const Visibility& map,
            const MapPart& part);
  [[nodiscard]] bool shades(const sim::Instances& instances) const;
  [[nodiscard]] InstanceVariant variant(const sim::Instances& instances) const;
  [[nodiscard]] CopyRaster::Copies copiesOf(const sim::Instances& instances) {
    return {&instances, &shapes_.of(instances)};
  }
  [[nodiscard]] ThingLook look(const sim::Instances& instances, std::size_t number);

  int samples_;
  Lighting lighting_;
  int shown_ = 0;
  InstanceShapes shapes_{false};
  InstanceBounds bounds_;
  std::vector<const sim::Instances*> balls_;
  std::vector<unsigned> ballIds_;
  BallRaster ballRaster_{BallRaster::Into::picture, samples_};
  BallRaster ballShadows_{BallRaster::Into::sunMap, 1, 64};
  std::vector<CopyRaster::Copies> copies_;
  std::vector<unsigned> copyIds_;
  CopyRaster copyRaster_{CopyRaster::Into::picture, samples_};
  CopyRaster copyShadows_{CopyRaster::Into::sunMap, 1, 64};
  BallRaster ballLampShadows_{BallRaster::Into::lampMap, 1, 64};
  CopyRaster copyLampShadows_{CopyRaster::Into::lampMap, 1, 64};
  CopyRaster copyGlows_{CopyRaster::Into::picture, samples_};
  GlowRaster glowRaster_{samples_};
  std::vector<InstanceColors> colors_;
  gl::Kernels<ShadeBalls> ballShading_{lighting_.lights};
  gl::Kernels<ShadeCopies> copyShading_{lighting_.lights};
};

}  // namespace simreel::draw
