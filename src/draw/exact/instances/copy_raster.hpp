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

/// Finds where copies of a mesh are nearest, by kernels: those in sight are listed, then an invocation
/// takes one triangle of one copy. The result does not depend on the order in which the device works.
class CopyRaster {
 public:
  using Into = Target;
  /// Triangles whose box has no side above `smallPixels` (0 to 64) are drawn by an invocation each, of the
  /// others those of at most `mediumPixels` (to 64) by sixteen, the rest by groups, tile by tile; `pairs`:
  /// so many triangles of copies at once. The same either way.
  CopyRaster(Into into, int samples, int smallPixels = smallCopyTriangle(), unsigned pairs = pairsAtOnce(),
             int mediumPixels = mediumTriangle());

  /// How many suit the device: each needs a word.
  [[nodiscard]] static unsigned pairsAtOnce();

  /// Copies of one mesh. The shape stays where it is.
  struct Copies {
    const sim::Instances* instances = nullptr;
    const InstanceShape* shape = nullptr;
    [[nodiscard]] unsigned triangles() const;
  };
  /// What is nearest, into what is cleared or drawn already. The uniform blocks, and for the sun's map
  /// the light's place, are bound.
  /// Numbers of copies[i] begin with firstIds[i]; maps have none.
  void drawNearest(const std::vector<Copies>& copies, const std::vector<unsigned>& firstIds,
                   const Visibility& into, const MapPart& map = {});
  /// The numbers of those that are nearest when all is drawn.
  void drawNumbers(const Visibility& into);
  /// Adds light to the sums of GlowRaster, before what is visible.
  void addLight(const std::vector<Copies>& copies, const Visibility& into, const gl::Buffer& sums);

  [[nodiscard]] CopySource source(const Copies& copies, unsigned firstId);

 private:
  enum class Pass { nearest, numbers, light };
  /// Copies that are drawn by one dispatch.
  struct Part {
    std::size_t draw;
    int skipped;
    int most;
  };
  void list(const std::vector<Copies>& copies, const Visibility& into);
  void run(Pass pass, const Visibility& into, const MapPart& map);
  void runPart(std::size_t part, Pass pass, const Visibility& into, const MapPart& map);

  Into into_;
  int samples_;
  int smallPixels_, mediumPixels_;
  unsigned pairs_;
  std::size_t listRoom_ = 0;
  std::vector<Copies> copies_;
  std::vector<unsigned> firstIds_;
  std::vector<int> firstListed_;
  std::vector<Part> parts_;
  std::vector<InstanceColors> colors_;
  std::map<const InstanceShape*, gl::Texture> indices_;
  const gl::Buffer* glows_ = nullptr;  ///< sums that addLight() adds to
  gl::Kernel<CullCopies> cull_;
  gl::Kernels<SmallCopies> copyKernels_;
  gl::Kernels<MediumCopies> mediumKernels_;
  gl::Kernels<LargeCopies> largeKernels_;
  GroupCounts groups_;
  gl::Buffer listed_, counts_, large_, largeCounts_, smallGroups_, largeGroups_;
  gl::Texture listedView_, countView_, largeView_, largeCountView_;
};

}  // namespace simreel::draw
