#pragma once
#include "draw/exact/instances/copy_raster.hpp"
#include "draw/exact/rays/hierarchy.hpp"
#include "draw/exact/rays/ray_emitters.hpp"
#include "draw/exact/rays/ray_looks.hpp"
#include "draw/instances/instance_values.hpp"
#include "sim/core/drawable.hpp"

#include <utility>
#include <vector>

namespace simreel::draw {

struct GatherSurface;
struct GatherCopies;
struct GatherBalls;

/// Scene of the path tracer: the triangles of all surfaces and mesh copies, the balls and the ground, but
/// not the glows.
class RayScene {
 public:
  RayScene(bool ground, RayMaterials materials)
      : ground_(ground),
        looks_(std::move(materials)),
        bounds_("bounds of what rays meet", 8 * sizeof(GLuint)) {}
  /// Builds the scene. The frame's uniform block must be bound. Throws UserError(device) if the scene
  /// exceeds the device's limits.
  void build(const sim::Drawables& drawables);
  /// Finds the first hit of the rays from `first` to first + count - 1 in the buffer `rays`. A ray and its
  /// hit have the same index in `rays` and `hits`.
  void trace(const gl::Texture& rays, const gl::Buffer& hits, int first, int count);
  /// Computes the fraction of light that reaches the end of each shadow ray. `lists`: two consecutive lists
  /// of ray indices, each with a capacity of `maximum` indices. `counters`: the lengths of the lists.
  void traceLight(const gl::Texture& rays, const gl::Buffer& hits, const gl::Texture& lists,
                  const gl::Buffer& counters, int maximum);
  /// Finds the first hit of the rays in a list. The list holds `count` ray indices relative to `first`.
  void traceListed(const gl::Texture& rays, const gl::Buffer& hits, int first, const gl::Texture& list,
                   int count);
  // Return the shader inputs of kernels that shade hits.
  [[nodiscard]] RayFeatures features() const;
  [[nodiscard]] RayLookFields lookFields() const;
  [[nodiscard]] SortedSolids sorted() const;
  [[nodiscard]] FoundFields found() const;
  [[nodiscard]] EmitterFields emitters() const;
  [[nodiscard]] const RayMaterials& materials() const { return looks_; }

 private:
  void count(const sim::Drawables& drawables);
  void gatherSurface(const sim::Surface& surface, int firstVertex, int firstTriangle, unsigned owner);
  void gatherCopies(const CopyRaster::Copies& copies, InstanceColors& colors, int firstVertex,
                    int firstTriangle, unsigned owner);
  void findEmitters(const sim::Drawables& drawables);
  void trace(TraceRays::Variant variant, TraceRays given, int count);
  void gatherBalls(const sim::Instances& balls, InstanceColors& colors, int firstBall, unsigned owner);
  [[nodiscard]] CopyRaster::Copies copiesOf(const sim::Instances& instances) {
    return {&instances, &shapes_.of(instances)};
  }

  bool ground_;
  RayMaterials looks_;
  RayEmitters emitters_;
  InstanceShapes shapes_{false};
  std::vector<InstanceColors> colors_;
  CopyRaster copyRaster_{CopyRaster::Into::picture, 1};
  Hierarchy triangles_{Hierarchy::Of::triangles}, balls_{Hierarchy::Of::balls};
  gl::Kernels<GatherSurface> gather_;
  gl::Kernel<GatherCopies> gatherCopies_;
  gl::Kernel<GatherBalls> gatherBalls_;
  gl::Kernels<TraceRays> trace_;
  gl::Buffer bounds_, places_, words_, corners_, lays_, ballPlaces_, ballLookBuffer_;
  gl::Texture placeView_, wordView_, cornerView_, layView_, ballPlaceView_, ballLookView_;
  int triangleCount_ = 0, vertexCount_ = 0, ballCount_ = 0;
};

}  // namespace simreel::draw
