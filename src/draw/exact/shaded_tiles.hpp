#pragma once
#include "draw/exact/triangle_raster.hpp"
#include "gl/texture.hpp"

#include <map>
#include <vector>

namespace simreel::draw {

/// Which tiles of the picture show which of the things drawn, so that each is shaded where it is seen. The
/// last two things are the ground where no shadow reaches it, and the ground elsewhere.
class ShadedTiles {
 public:
  static constexpr int side = 8;  ///< pixels of a tile: tileSide of glsl/draw/exact/fixed.glsl
  /// For pictures like that one.
  ShadedTiles(const Visibility& visibility, bool ground, bool shadow);

  /// Whether list() empties the light of its pixels on this device: cards for computing clear textures in
  /// ten times the time that it takes there.
  [[nodiscard]] static bool emptiesLight();
  /// Lays the ground under what is visible and makes the lists; the sums of light are bound. `firstIds`: of
  /// the things, ascending. `groundRows`: from which to before which row of the band, in whole tiles, rays
  /// may meet the ground. `groundKeys`: the ground is among what is nearest afterwards.
  void list(const std::vector<unsigned>& firstIds, const Visibility& visibility, glm::ivec2 groundRows,
            bool groundKeys = false);
  /// Runs a shading kernel over the tiles of a thing. `program` includes draw/exact/shaded_tile.glsl.
  void shade(int thing, const gl::Program& program) const;
  [[nodiscard]] int things() const { return things_; }  ///< but for the ground

 private:
  /// A bit each: the ground, its keys, and few things.
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
