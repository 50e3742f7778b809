#pragma once
#include "draw/exact/rays/ray_scene.hpp"
#include "draw/exact/shown.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

namespace simreel::draw {

struct PathVariant;
struct RayPaths;
struct ListSpots;
struct StartPaths;
struct GoOnPaths;
struct BouncePaths;
struct SumPaths;
struct ResolveSpots;

/// Lights a picture by path tracing, with the light of the sun, the lamps and the sky, and with one bounce
/// of indirect light. With the define RAYS, shading kernels store surface points (spots) instead of
/// lighting them. Paths start at these spots.
class RayLight {
 public:
  /// Max indirect light per sample, relative to the light that the picture shows as white. The limit
  /// suppresses fireflies.
  static constexpr float maxIndirect = 10.0F;
  /// Max number of samples per band. Each sample needs 88 bytes.
  static constexpr std::size_t sampleLimit = std::size_t{1} << 20U;

  struct Options {
    int raySamples = 64;  ///< number of light samples per pixel
    bool ground = false;
    bool openSun = false;  ///< true if no object casts a shadow in sunlight
  };
  /// `samples`: number of samples per band.
  RayLight(const Options& options, const Lighting& lighting, std::size_t samples, RayMaterials materials);

  /// Builds the ray scene of a picture. The frame's uniform block must be bound.
  void build(const sim::Drawables& drawables) { scene_.build(drawables); }
  /// Selects the lens point with index `point` among `points` lens points. The samples of each pixel are
  /// divided between the lens points.
  void selectLensPoint(int point, int points);
  [[nodiscard]] const RayMaterials& materials() const { return scene_.materials(); }
  /// Returns the buffer into which shading kernels store spots, the visible surface points
  /// (glsl/draw/exact/rays/spots.glsl).
  [[nodiscard]] const gl::Buffer& spots() const { return spots_; }
  /// Adds the light of a band's spots to `sums`. The uniform blocks of view, lights and frame must be
  /// bound. `linear`: true if no light is compressed (glsl/draw/exact/screen/edge_light.glsl). `white`:
  /// light that the picture shows as white.
  void add(const Visibility& visibility, const gl::Texture& sums, bool linear, int rows, float white);

 private:
  [[nodiscard]] PathVariant pathVariant(const RayFeatures& all) const;
  [[nodiscard]] RayPaths pathsOf(int firstSpot, int spots, int firstSample, int paths) const;
  void clearCounts();
  [[nodiscard]] int counted() const;
  [[nodiscard]] int listSpots(const Visibility& visibility, int rows);
  void follow(int firstSpot, int spots, int firstSample, int samples, float white);
  void traceLight(int firstKind, int paths);
  void continuePaths(int firstSpot, int spots, int firstSample, int paths);

  Options options_;
  ShadeVariant shade_;
  gl::Kernels<ListSpots> listSpots_;
  gl::Kernels<StartPaths> start_;
  gl::Kernels<GoOnPaths> goOn_;
  gl::Kernels<BouncePaths> bounce_;
  gl::Kernels<SumPaths> sum_;
  gl::Kernels<ResolveSpots> resolve_;
  RayScene scene_;
  int raySamples_;  ///< samples per pixel through the current lens point
  unsigned sampleMask_ = 0, samplesBefore_ = 0;
  gl::Buffer spots_, spotLight_, list_, count_, rays_, hits_, light_, lightRays_, goingOn_[2];
  gl::Texture spotView_, spotLightView_, listView_, rayView_, hitView_, lightView_, lightRayView_,
      goingOnView_[2];
};

}  // namespace simreel::draw
