#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/visibility.hpp"

#include <functional>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// How many triangles are best listed by tiles on this device instead of drawn by atomics: none but on
/// software drivers, to whom those are dear.
[[nodiscard]] int binnedTriangles();

/// Those of glsl/draw/exact/triangles/bins.glsl that make lists.
struct BinFields {
  gl::Shared<"BinBlock"> bins;
  gl::Shared<"NodeBlock"> nodes;
  gl::Shared<"CornerBlock"> corners;
  gl::Uniform<"binTiles", int> tiles;
  gl::Uniform<"roundTriangles", int> roundTriangles;
  gl::Uniform<"face", int> face;
  gl::Uniform<"faceRounds", int> faceRounds;
  gl::Uniform<"rounds", int> rounds;
  gl::Uniform<"cornerRoom", int> cornerRoom;
  gl::Uniform<"sharedNodes", int> sharedNodes;
  gl::Uniform<"firstSharedNode", unsigned> firstSharedNode;
};
struct BinnedTriangles;

/// Triangles by the tiles of 8 by 8 pixels that they meet, and what of them is nearest there, found a
/// tile a group without atomics (glsl/draw/exact/triangles/bins.glsl). The same as drawing them one by one.
/// 80 bytes a triangle.
class TriangleBins {
 public:
  /// Whether so many triangles at most may be listed, of a picture, or of each of so many faces of maps.
  [[nodiscard]] static bool holds(int triangles, int faces = 0);
  /// Empties the lists, for a picture or faces of that size: for `room` triangles at most, and four times
  /// as many places of one in a tile beside four of each.
  void begin(glm::ivec2 size, int triangles, int room, int faces = 0);
  /// For kernels with BINS, of that face.
  [[nodiscard]] BinFields fields(int face) const;
  /// Into what larger ones have been drawn to already, numbers of none of them. The view block is bound, or
  /// `faceOf` says where a face of lamps' maps lies and how it is seen.
  void draw(Target target, const Visibility& into,
            const std::function<const MapFace&(int face)>& faceOf = {});

 private:
  int tiles_ = 0;
  int rounds_ = 1;
  int faceRounds_ = 1;
  int room_ = 0;  ///< triangles
  int sharedNodes_ = 0;
  GroupCounts counts_;
  gl::Buffer bins_, nodes_, corners_, groups_;
  gl::Texture binView_, nodeView_, cornerView_;
  gl::Kernels<BinnedTriangles> kernels_;
};

}  // namespace simreel::draw
