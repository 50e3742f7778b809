#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/visibility.hpp"

#include <functional>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Returns the max number of triangles that are sorted into tile bins instead of being drawn with atomics.
/// Returns 0 on GPUs, because atomics are slow only on software drivers.
[[nodiscard]] int binnedTriangles();

/// Shader inputs of kernels that write the lists (glsl/draw/exact/triangles/bins.glsl).
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

/// Lists triangles by the 8x8 pixel tiles that they touch. One workgroup per tile then finds the nearest
/// triangle of each sample without atomics (glsl/draw/exact/triangles/bins.glsl). The result is the same as
/// if the triangles were drawn one by one. The bins take 80 bytes per triangle.
class TriangleBins {
 public:
  /// True if the bins can hold `triangles` triangles for a picture (faces = 0) or for each of `faces`
  /// shadow map faces.
  [[nodiscard]] static bool holds(int triangles, int faces = 0);
  /// Clears the lists for a picture or for shadow map faces of `size`. Allocates memory for `room`
  /// triangles. Each triangle has four list nodes of its own; 4 * room more nodes are available to all
  /// triangles.
  void begin(glm::ivec2 size, int triangles, int room, int faces = 0);
  /// Returns the shader inputs of kernels with the define BINS, for one face.
  [[nodiscard]] BinFields fields(int face) const;
  /// Rasterizes the listed triangles. The buffer may already contain the keys of larger triangles, but not
  /// their ids. Either the view block must be bound, or `faceOf` returns each lamp map face with its view.
  void draw(Target target, const Visibility& into,
            const std::function<const MapFace&(int face)>& faceOf = {});

 private:
  int tiles_ = 0;
  int rounds_ = 1;
  int faceRounds_ = 1;
  int room_ = 0;  ///< max number of triangles
  int sharedNodes_ = 0;
  GroupCounts counts_;
  gl::Buffer bins_, nodes_, corners_, groups_;
  gl::Texture binView_, nodeView_, cornerView_;
  gl::Kernels<BinnedTriangles> kernels_;
};

}  // namespace simreel::draw
