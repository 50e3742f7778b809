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

/// The light of what a picture shows, found by rays: of the sun, of lamps, of the sky, and what comes by
/// way of one other place. Shading kernels with RAYS keep spots instead of lighting them; here paths begin
/// there.
class RayLight {
 public:
  /// No ray brings more light by way of something else (of the picture's white, before film).
  static constexpr float mostOnward = 10.0F;
  /// Samples of a band at most: what is kept of each comes to 88 bytes.
  static constexpr std::size_t mostSamples = std::size_t{1} << 20U;

  struct Options {
    int raySamples = 64;  ///< of each pixel
    bool ground = false;
    bool openSun = false;  ///< nothing keeps its light out
  };
  /// `samples`: of a band.
  RayLight(const Options& options, const Lighting& lighting, std::size_t samples, RayLooks looks);

  /// For each picture. The frame's uniform block is bound.
  void build(const sim::Drawables& drawables) { scene_.build(drawables); }
  /// Of how many points of a lens this is one, and which.
  void seeThrough(int point, int points);
  [[nodiscard]] const RayLooks& looks() const { return scene_.looks(); }
  /// The places to be lit, which shading kernels keep.
  [[nodiscard]] const gl::Buffer& spots() const { return spots_; }
  /// Adds the light of a band's spots to the bound sums. What is visible, the view, the lights and the
  /// frame are bound. `white`: light that a picture shows as white.
  void add(const Visibility& visibility, const gl::Texture& sums, int rows, float white);

 private:
  [[nodiscard]] PathVariant pathVariant(const RayFeatures& all) const;
  [[nodiscard]] RayPaths pathsOf(int firstSpot, int spots, int firstSample, int paths) const;
  void clearCounts();
  [[nodiscard]] int counted() const;
  [[nodiscard]] int listSpots(const Visibility& visibility, int rows);
  void follow(int firstSpot, int spots, int firstSample, int samples, float white);
  void traceLight(int firstKind, int paths);
  void goOn(int firstSpot, int spots, int firstSample, int paths);

  Options options_;
  ShadeVariant shade_;
  gl::Kernels<ListSpots> listSpots_;
  gl::Kernels<StartPaths> start_;
  gl::Kernels<GoOnPaths> goOn_;
  gl::Kernels<BouncePaths> bounce_;
  gl::Kernels<SumPaths> sum_;
  gl::Kernels<ResolveSpots> resolve_;
  RayScene scene_;
  int raySamples_;  ///< through this point of the lens
  unsigned sampleMask_ = 0, samplesBefore_ = 0;
  gl::Buffer spots_, spotLight_, list_, count_, rays_, hits_, light_, lightRays_, goingOn_[2];
  gl::Texture spotView_, spotLightView_, listView_, rayView_, hitView_, lightView_, lightRayView_,
      goingOnView_[2];
};

}  // namespace simreel::draw
