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

/// What rays meet of a picture's scene: triangles of all surfaces and of copies of meshes, balls, and the
/// ground. What adds light is not among it.
class RayScene {
 public:
  RayScene(bool ground, RayLooks looks)
      : ground_(ground),
        looks_(std::move(looks)),
        bounds_("bounds of what rays meet", 8 * sizeof(GLuint)) {}
  /// The frame's uniform block is bound. Throws UserError(device) where there is more than the device
  /// holds.
  void build(const sim::Drawables& drawables);
  /// What rays `first` to before `first + count` of a buffer meet first; `hits` as large.
  void trace(const gl::Texture& rays, const gl::Buffer& hits, int first, int count);
  /// Whether light gets along those whose numbers are in two lists, of as many as two counters say, `most`
  /// each; the second list lies behind `most` places for the first.
  void traceLight(const gl::Texture& rays, const gl::Buffer& hits, const gl::Texture& lists,
                  const gl::Buffer& counters, int most);
  /// The nearest of those behind `first` whose numbers are in a list.
  void traceListed(const gl::Texture& rays, const gl::Buffer& hits, int first, const gl::Texture& list,
                   int count);
  // For kernels that find out what has been met.
  [[nodiscard]] RayFeatures features() const;
  [[nodiscard]] RayLookFields lookFields() const;
  [[nodiscard]] SortedSolids sorted() const;
  [[nodiscard]] FoundFields found() const;
  [[nodiscard]] EmitterFields emitters() const;
  [[nodiscard]] const RayLooks& looks() const { return looks_; }

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
  RayLooks looks_;
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
