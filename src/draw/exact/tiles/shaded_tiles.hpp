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

/// Where on the picture the ground may be.
struct GroundPlace {
  glm::ivec2 rows{0};  ///< rowsTowardsGround() in whole tiles
  glm::vec4 near{0};   ///< nearOfGround()
  glm::vec3 rays{0};   ///< raysAside()
};

/// Which tiles of the picture show which of the things drawn, so that each is shaded where it is seen. The
/// last two things are the ground where no shadow reaches it, and the ground elsewhere.
class ShadedTiles {
 public:
  static constexpr int side = 8;  ///< pixels of a tile: tileSide of glsl/draw/exact/fixed.glsl
  /// For pictures like that one; `empties`: list() may empty the light of its pixels.
  ShadedTiles(const Visibility& visibility, bool ground, bool shadow, bool empties = true);
  /// Whether list() has found anything to shade. Waits for the device.
  [[nodiscard]] bool any() const;

  /// Whether list() empties the light of its pixels on this device: cards for computing clear textures in
  /// ten times the time that it takes there.
  [[nodiscard]] static bool emptiesLight();
  /// Lays the ground under what is visible and makes the lists. `firstIds`: of the things, ascending.
  /// `sums`: the light. `groundKeys`: the ground is among what is nearest afterwards.
  void list(const std::vector<unsigned>& firstIds, const Visibility& visibility, const gl::Texture& sums,
            const GroundPlace& place, bool groundKeys = false);
  /// Runs a shading kernel over the tiles of a thing; sets its `tile`.
  template <class Interface>
  void shade(int thing, const gl::Kernel<Interface>& kernel, Interface given) const {
    given.tile = tile(thing);
    GroupCounts::dispatch(kernel, dispatches_, static_cast<std::size_t>(thing), given);
  }
  [[nodiscard]] int things() const { return things_; }  ///< but for the ground

 private:
  [[nodiscard]] TileFields tile(int thing) const;

  glm::ivec2 size_, tiles_;
  int things_ = 0;
  bool ground_, shadow_, empties_;
  const Visibility* visibility_ = nullptr;  ///< whose tiles are listed
  gl::Kernels<TileKernel> kernels_;
  GroupCounts groups_;
  gl::Buffer firstIds_, lists_, counters_, dispatches_;
  gl::Texture firstIdView_, listView_, counterView_;
};

}  // namespace simreel::draw
