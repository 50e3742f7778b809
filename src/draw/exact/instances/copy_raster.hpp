#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/instances/instance_source.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <map>
#include <vector>

namespace simreel::draw {

struct CullCopies;
struct SmallCopies;
struct MediumCopies;
struct LargeCopies;

/// Rasterizes mesh copies with kernels. First lists the potentially visible copies, then handles one
/// triangle of one copy per invocation. The result does not depend on the execution order.
class CopyRaster {
 public:
  using Into = Target;
  /// One invocation rasterizes a triangle whose bounding box has at most `smallPixels` (0 to 64) per side.
  /// Sixteen invocations rasterize a medium triangle, of at most `mediumPixels` (up to 64) per side.
  /// Workgroups rasterize larger triangles, tile by tile. `pairs`: max number of (copy, triangle) pairs per
  /// dispatch. These limits do not change the result.
  CopyRaster(Into into, int samples, int smallPixels = smallCopyTriangle(), unsigned pairs = pairsAtOnce(),
             int mediumPixels = mediumTriangle());

  /// Returns the number of (copy, triangle) pairs per dispatch that suits the device. Each pair needs one
  /// word.
  [[nodiscard]] static unsigned pairsAtOnce();

  /// Copies of one mesh. The shape must not be moved in memory.
  struct Copies {
    const sim::Instances* instances = nullptr;
    const InstanceShape* shape = nullptr;
    [[nodiscard]] unsigned triangles() const;
  };
  /// Writes depth keys into a buffer that may already contain other objects. The uniform blocks and, for
  /// the sun's map, its transform must be bound. The ids of copies[i] start at firstIds[i]; shadow maps
  /// have no ids.
  void drawNearest(const std::vector<Copies>& copies, const std::vector<unsigned>& firstIds,
                   const Visibility& into, const MapPart& map = {});
  /// Writes the ids of the nearest copies. Call after all objects have written their keys.
  void drawIds(const Visibility& into);
  /// Sets whether haze dims the light that addLight() adds.
  void setHazy(bool hazy) { hazy_ = hazy; }
  /// Adds the light of additive copies to the sums of GlowRaster, as far as the copies are in front of the
  /// visible surfaces.
  void addLight(const std::vector<Copies>& copies, const Visibility& into, const gl::Buffer& sums);

  [[nodiscard]] CopySource source(const Copies& copies, unsigned firstId);

 private:
  enum class Pass { nearest, numbers, light };
  /// Range of copies that one dispatch handles.
  struct Part {
    std::size_t draw;
    int skipped;
    int maximum;
  };
  void list(const std::vector<Copies>& copies, const Visibility& into);
  void run(Pass pass, const Visibility& into, const MapPart& map);
  void runPart(std::size_t part, Pass pass, const Visibility& into, const MapPart& map);

  Into into_;
  int samples_;
  int smallPixels_, mediumPixels_;
  unsigned pairs_;
  bool hazy_ = false;
  std::size_t listRoom_ = 0;
  std::vector<Copies> copies_;
  std::vector<unsigned> firstIds_;
  std::vector<int> firstListed_;
  std::vector<Part> parts_;
  std::vector<InstanceColors> colors_;
  std::map<const InstanceShape*, gl::Texture> indices_;
  const gl::Buffer* glows_ = nullptr;  ///< light sums that addLight() increases
  gl::Kernel<CullCopies> cull_;
  gl::Kernels<SmallCopies> copyKernels_;
  gl::Kernels<MediumCopies> mediumKernels_;
  gl::Kernels<LargeCopies> largeKernels_;
  GroupCounts groups_;
  gl::Buffer listed_, counts_, large_, largeCounts_, smallGroups_, largeGroups_;
  gl::Texture listedView_, countView_, largeView_, largeCountView_;
};

}  // namespace simreel::draw
