#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/shown.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/element_array.hpp"
#include "gl/texture.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

struct TileKernel;

/// Area of the picture that may show the ground.
struct GroundPlace {
  glm::ivec2 rows{0};  ///< range of tile rows whose rays may hit the ground, computed by
                       ///< rowsTowardsGround()
  glm::vec4 near{0};  ///< nearness of the ground as a function of the pixel, computed by groundNearnessOf()
  glm::vec3 rays{0};  ///< bounds of the ray directions, computed by rayBounds()
};

/// Lists, for each object, the tiles of the picture that show it, so that shading kernels run only on these
/// tiles. Two more lists hold the tiles that show ground without shadow, and the other tiles that show
/// ground.
class ShadedTiles {
 public:
  static constexpr int side = 8;  ///< pixels per tile side: tileSide of glsl/draw/exact/fixed.glsl
  /// Prepares for pictures with the size and layout of `visibility`. `empties`: true if list() may clear
  /// the light of the listed pixels.
  ShadedTiles(const Visibility& visibility, bool ground, bool shadow, bool empties = true);
  /// True if list() has found anything to shade. Waits for the GPU.
  [[nodiscard]] bool any() const;

  /// True if list() clears the light of the listed pixels on this device. Clearing a whole texture would
  /// take ten times as long on compute GPUs.
  [[nodiscard]] static bool emptiesLight();
  /// Adds the ground behind the visible objects and writes the lists. `firstIds`: first primitive id of
  /// each object, ascending. `sums`: the light. `groundKeys`: true to write the ground into the depth keys
  /// too.
  void list(const std::vector<unsigned>& firstIds, const Visibility& visibility, const gl::Texture& sums,
            const GroundPlace& place, bool groundKeys = false);
  /// Runs a shading kernel on the listed tiles of an object. Sets the kernel's `tile` fields.
  template <class Interface>
  void shade(int thing, const gl::Kernel<Interface>& kernel, Interface given) const {
    given.tile = tile(thing);
    GroupCounts::dispatch(kernel, dispatches_, static_cast<std::size_t>(thing), given);
  }
  [[nodiscard]] int things() const { return things_; }  ///< number of objects, not counting the ground

 private:
  [[nodiscard]] TileFields tile(int thing) const;

  glm::ivec2 size_, tiles_;
  int things_ = 0;
  bool ground_, shadow_, empties_;
  const Visibility* visibility_ = nullptr;  ///< visibility buffer for which the lists were made
  gl::Kernels<TileKernel> kernels_;
  GroupCounts groups_;
  gl::Buffer firstIds_, lists_, counters_, dispatches_;
  gl::Texture firstIdView_, listView_, counterView_;
};

}  // namespace simreel::draw
