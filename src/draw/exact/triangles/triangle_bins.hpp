#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/visibility.hpp"

#include <functional>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// How many triangles are best listed by tiles on this device instead of drawn by atomics: none but on
/// software drivers, to whom those are dear.
[[nodiscard]] int binnedTriangles();

/// Triangles by the tiles of 8 by 8 pixels that they meet, and what of them is nearest there, found a
/// tile a group without atomics (glsl/draw/exact/triangles/bins.glsl). The same as drawing them one by one.
/// 80 bytes a triangle.
class TriangleBins {
 public:
  /// `defines`: of what is drawn to; SUN_MAP and LAMP_MAP have keys alone.
  TriangleBins(gl::Defines defines, int samples);

  /// Whether so many triangles at most may be listed, of a picture, or of each of so many faces of maps.
  [[nodiscard]] static bool holds(int triangles, int faces = 0);
  /// Empties the lists, for a picture or faces of that size: for `room` triangles at most, and four times
  /// as many places of one in a tile beside four of each.
  void begin(glm::ivec2 size, int triangles, int room, int faces = 0);
  /// For kernels with BINS, of that face.
  void bind(const gl::Program& program, int face = 0) const;
  /// Into what larger ones have been drawn to already, numbers of none of them. The uniform blocks are
  /// bound, or `bindFace` binds those of a face; what made the lists is behind a barrier.
  void draw(const Visibility& into,
            const std::function<void(int face, const gl::Program& program)>& bindFace = {});

 private:
  gl::Defines defines_;
  int tiles_ = 0;
  int rounds_ = 1;
  int faceRounds_ = 1;
  int room_ = 0;  ///< triangles
  int sharedNodes_ = 0;
  GroupCounts counts_;
  gl::Buffer bins_, nodes_, corners_, groups_;
  gl::Texture binView_, nodeView_, cornerView_;
  gl::Program program_;
};

}  // namespace simreel::draw
