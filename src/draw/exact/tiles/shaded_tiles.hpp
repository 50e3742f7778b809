#pragma once
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gl/texture.hpp"

#include <map>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

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
  /// Lays the ground under what is visible and makes the lists; the sums of light are bound. `firstIds`: of
  /// the things, ascending. `groundKeys`: the ground is among what is nearest afterwards.
  void list(const std::vector<unsigned>& firstIds, const Visibility& visibility, const GroundPlace& place,
            bool groundKeys = false);
  /// Runs a shading kernel over the tiles of a thing. `program` includes draw/exact/tiles/shaded_tile.glsl.
  void shade(int thing, const gl::Program& program) const;
  [[nodiscard]] int things() const { return things_; }  ///< but for the ground

 private:
  /// A bit each: the ground, its keys, few things, and how many fours of them.
  const gl::Program& program(unsigned features);

  glm::ivec2 size_, tiles_;
  int things_ = 0;
  gl::Defines defines_;
  bool ground_;
  std::map<unsigned, gl::Program> programs_;
  GroupCounts groups_;
  gl::Buffer firstIds_, lists_, counters_, dispatches_;
  gl::Texture firstIdView_, listView_, counterView_;
};

}  // namespace simreel::draw
