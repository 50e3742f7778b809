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

/// Draws instances by kernels in exact arithmetic. What is opaque has numbers of its own after those of the
/// surfaces: first of the draw + instance.
class ExactInstances {
 public:
  ExactInstances(int samples, Lighting lighting);

  /// From now on things are lit like that, by the same lights.
  void light(const ThingVariant& variant) { lighting_.variant = variant; }
  /// As SurfaceShading::show.
  void show(int layer) { shown_ = layer; }
  /// Whether some of what is opaque mirror the scene.
  [[nodiscard]] static bool anyMirrors(const sim::Drawables& drawables);
  /// Grows the sun's bounds; see ShadowPass::fit.
  void growBounds(const sim::Drawables& drawables, const gl::Buffer& bounds) {
    bounds_.grow(drawables, shapes_, bounds);
  }
  /// Into the sun's map, where other things may be drawn already. The light's place is bound.
  void castShadows(const sim::Drawables& drawables, const Visibility& map, const MapPart& part);
  /// Into one of a lamp's maps, whose view is bound.
  void castLampShadows(const sim::Drawables& drawables, const Visibility& maps, const MapPart& part);
  /// Numbers what is opaque from `firstId` on. Adds the first of each draw to `firstIds`. Throws
  /// UserError(device) where there are more than numbers.
  void number(const sim::Drawables& drawables, unsigned firstId, std::vector<unsigned>& firstIds);
  /// What is nearest: before anything has drawn numbers.
  void drawNearest(const Visibility& picture);
  /// The numbers, when everything has drawn what is nearest.
  void drawNumbers(const Visibility& picture);
  /// What has these numbers.
  void describe(std::vector<DrawnThing>& things) const;
  struct Numbered {
    const sim::Instances* instances;
    unsigned firstId, each;  ///< of the first; of each of them
  };
  [[nodiscard]] std::vector<Numbered> numbered() const;
  /// Adds the light of what is opaque, whose draws are things of the tiles from `firstThing` on.
  void shade(const ShadedTiles& tiles, int firstThing, const SceneLight& light);
  /// Whether some add light: then the ground lies in the picture's keys, too.
  [[nodiscard]] static bool anyAdd(const sim::Drawables& drawables);
  /// Adds to `light` that of those that add it, before what is visible.
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
