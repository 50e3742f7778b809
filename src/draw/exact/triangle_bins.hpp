#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/visibility.hpp"

#include <map>
#include <string>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Whether small triangles are best listed by tiles on this device instead of drawn by atomics: on software
/// drivers, to whom those are dear.
[[nodiscard]] bool binsTriangles();

/// Small triangles by the tiles of 8 by 8 pixels that they meet, and what of them is nearest there, found a
/// tile a group without atomics (glsl/draw/exact/triangles/bins.glsl). The same as drawing them one by one.
/// 80 bytes a triangle.
class TriangleBins {
 public:
  static constexpr int maxTriangles = 1 << 20;
  /// `sunMap`: keys alone.
  TriangleBins(bool sunMap, int samples) : sunMap_(sunMap), samples_(samples) {}

  /// Empties the lists, for so many triangles of a picture of that size.
  void begin(glm::ivec2 size, int triangles);
  /// For kernels with BINS.
  void bind(const gl::Program& program) const;
  /// Into what larger ones have been drawn to already, numbers of none of them. The uniform blocks are
  /// bound, and what made the lists is behind a barrier.
  void draw(const Visibility& into);

 private:
  bool sunMap_;
  int samples_;
  int tiles_ = 0;
  int rounds_ = 1;
  int triangles_ = 0;
  int sharedNodes_ = 0;
  GroupCounts counts_;
  gl::Buffer bins_, nodes_, corners_, groups_;
  gl::Texture binView_, nodeView_, cornerView_;
  gl::Program program_;
};

}  // namespace simreel::draw
