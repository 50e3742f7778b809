#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/triangles/triangle_bins.hpp"
#include "draw/exact/visibility.hpp"
#include "sim/core/drawable.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace simreel::draw {

class JoinedSurfaces;

/// These functions return the max number of vertices and triangles of a surface, derived from its buffer
/// sizes.
[[nodiscard]] inline int verticesOf(const sim::Surface& surface) {
  return std::max(surface.vertexCount, surface.vertexCapacity);
}
[[nodiscard]] inline int maxTrianglesOf(const sim::Surface& surface) {
  const std::size_t indices = surface.arguments == nullptr ? static_cast<std::size_t>(surface.indexCount)
                                                           : surface.indices->bytes() / sizeof(GLuint);
  return static_cast<int>(indices / 3);
}

/// Lists of triangles of one mesh, stored one after another on the GPU.
struct TriangleLists {
  const gl::Texture* places = nullptr;   ///< vertex positions of the mesh in world space (m), RGBA32F
  const gl::Texture* indices = nullptr;  ///< vertex indices, R32UI, three per triangle
  const gl::Texture* numbers = nullptr;  ///< triangle indices of all lists, R32UI
  const gl::Buffer* counts = nullptr;    ///< length of each list
  int room = 0;                          ///< capacity of each list (triangles)
};

/// Uniforms, buffers and textures that glsl/draw/exact/triangles/surface_triangle.glsl declares.
struct TriangleSource {
  gl::In<"vertices"> vertices;
  gl::In<"places"> places;  ///< vertex positions of a merged mesh, used instead of `vertices`
  gl::In<"indices"> indices;
  gl::Uniform<"firstVertex", int> firstVertex;
  gl::Uniform<"triangleCount", int> triangleCount;
  gl::Uniform<"firstIndex", int> firstIndex;
  gl::In<"DrawArgumentBlock"> counts;
  gl::In<"lists"> lists;
  gl::Uniform<"list", int> list;
  gl::Uniform<"rowOf", glm::ivec2> rowOf;
};

struct Cutout;
struct RasterTriangles;
struct RasterVariant;
struct VertexKernel;
struct SmallTriangles;
struct MediumTriangles;
struct LargeTriangles;
struct ClipTriangles;

/// Rasterizes the triangles of surfaces into a visibility buffer with kernels. Coverage is computed in
/// integers. At equal depth the lower id wins. The result does not depend on the execution order.
class TriangleRaster {
 public:
  using Into = Target;
  /// One invocation rasterizes a triangle whose bounding box has at most `smallPixels` (0 to 64) per side.
  /// Sixteen invocations rasterize a medium triangle, of at most `mediumPixels` (up to 64) per side.
  /// Workgroups rasterize larger triangles, tile by tile. The limits do not change the result. Up to
  /// `fanRoom` large triangles (128 bytes each) are clipped once for all invocations that rasterize them.
  /// `binRoom`: max number of small triangles that are binned by tile; only for the sample layout
  /// `separate`.
  TriangleRaster(Into into, int samples, int smallPixels = smallTriangle(), int fanRoom = fansOfTriangles(),
                 int mediumPixels = mediumTriangle(), int binRoom = binnedTriangles());

  /// Parameters of one drawn surface, or of one triangle list of a lamp map.
  struct Drawn {
    const sim::Surface* surface = nullptr;
    int firstVertex = 0;
    int firstIndex = 0;  ///< three times the index of the surface's first entry in the list of large
                         ///< triangles
    int maxTriangles = 0;
    unsigned firstId = 0;  ///< id of the first triangle
    int firstFan = 0;      ///< index of the surface's first clipped triangle (fan)
    int fans = 0;          ///< max number of the surface's clipped triangles
    gl::Texture indices;   ///< vertex indices, R32UI texel view
    int list = 0;          ///< for lamp maps: index of the triangle list
    MapFace face;          ///< for lamp maps: the face that shows the list
  };

  /// Description of cut-out surfaces and of the current layer of blended surfaces. All pointers must stay
  /// valid during drawing.
  struct Fragments {
    /// Returns true if a surface has holes. In that case, `holes` returns the kernel inputs that describe
    /// them.
    std::function<bool(const sim::Surface&)> cut = {};
    std::function<Cutout(const sim::Surface&)> holes = {};
    const sim::Surface* only = nullptr;  ///< for lamp maps: the surface that the triangle lists belong to
    bool layers = false;                 ///< true to draw the next layer behind `before`, or the first
                                         ///< layer if `before` is null
    const Visibility* before = nullptr;
    const Visibility* behind = nullptr;  ///< opaque surfaces; layers behind them are not drawn
  };
  /// Returns a rasterizer for surfaces with Fragments. It tests each sample separately. Workgroups
  /// rasterize all triangles that are not small.
  static TriangleRaster ofFragments(Into into, int samples) {
    return {into, samples, smallTriangle(), 0, 0, 0};
  }
  void tellFragments(Fragments fragments) { fragments_ = std::move(fragments); }

  /// Assigns consecutive ids to the triangles, starting at `firstId`; see drawn(). Throws UserError(device)
  /// if there are not enough ids.
  void number(const std::vector<const sim::Surface*>& surfaces, unsigned firstId = 0);
  /// Prepares lamp maps instead of a picture. Face i shows the triangles of list i. The arguments must stay
  /// valid until the maps are drawn.
  void number(const TriangleLists& lists, const std::vector<MapFace>& faces);
  /// Prepares lamp maps that are drawn in one dispatch, which is best on GPUs. `views`: the views of all
  /// maps in sequence; `first`: index of the view of face 0.
  void number(const TriangleLists& lists, const std::vector<MapFace>& faces, const gl::Buffer& views,
              int first);
  /// Rasterizes the prepared triangles into a cleared buffer. The uniform blocks and, for the sun's map,
  /// its transform must be bound. For lamp maps this function binds the views of the faces.
  void draw(const Visibility& into, const MapPart& part = {});
  /// These functions are the two steps of draw() for pictures. drawNearest() writes the depth keys, before
  /// any object writes ids. drawIds() writes the ids, after all objects have written their keys.
  void drawNearest(const Visibility& into);
  void drawIds(const Visibility& into);
  /// Rasterizes the prepared surfaces in one pass, as the joined mesh.
  void drawJoined(const Visibility& into, const JoinedSurfaces& joined);
  [[nodiscard]] const std::vector<Drawn>& drawn() const { return drawn_; }
  /// Returns the shader inputs of kernels that read the triangles of an entry of drawn().
  [[nodiscard]] TriangleSource source(const Drawn& drawn) const;
  /// Returns the shader inputs for the joined surfaces that were drawn last.
  [[nodiscard]] TriangleSource wholeSource() const { return source(joinedEntry_); }

 private:
  enum class Step { small, medium, clip, large };
  void drawEntries(const Visibility& into, const MapPart& part);
  void drawNearestOfEntries(const Visibility& into, const MapPart& part);
  void drawIdsOfEntries(const Visibility& into);
  void makeVertices(const Visibility& into);
  void clipLarge(const Visibility& into);
  void prepareLarge(glm::ivec2 size);
  void reserveLists(std::size_t draws, std::int64_t triangles, int fans);
  [[nodiscard]] RasterTriangles raster(const Drawn& drawn, const Visibility& into) const;
  [[nodiscard]] RasterVariant variant(const Visibility& into, int pass) const;
  /// Calls `dispatch` with the kernel of a step and the kernel's inputs.
  template <class Dispatch>
  void runKernel(Step step, bool clips, const RasterVariant& variant, const RasterTriangles& raster,
                 const Drawn& drawn, const Dispatch& dispatch);
  void runFaces(Step step, int pass, const Visibility& into, bool clips);
  /// Returns the surface of an entry, whose holes are left out.
  [[nodiscard]] const sim::Surface* surfaceOf(const Drawn& drawn) const;
  [[nodiscard]] bool hasHoles(const Drawn& drawn) const;
  [[nodiscard]] bool anyHoles() const;
  void fillGroups();
  void drawBinned(const Visibility& into);
  void run(Step step, int pass, const Visibility& into, bool clips = false);
  void runLists(int pass, const Visibility& into);

  Into into_;
  Fragments fragments_;
  int samples_;
  int smallPixels_;
  int fanRoom_;
  int mediumPixels_;
  int binRoom_;
  bool binned_ = false;  ///< true if the triangles of the current drawing are binned by tile
  gl::Kernels<VertexKernel> vertexKernels_;
  gl::Kernels<SmallTriangles> small_;
  gl::Kernels<MediumTriangles> medium_;
  gl::Kernels<ClipTriangles> clip_;
  gl::Kernels<LargeTriangles> largeOnes_;
  GroupCounts groups_;
  TriangleBins bins_;
  TriangleLists lists_;                    ///< triangle lists of the lamp maps
  const gl::Buffer* faceViews_ = nullptr;  ///< views of all lamp maps, if they are drawn in one dispatch
  int firstView_ = 0;
  std::vector<Drawn> drawn_;
  std::span<Drawn> entries_;                ///< entries to draw: all entries of drawn_, or only whole_
  Drawn joinedEntry_;                       ///< the joined surfaces as one entry
  const JoinedSurfaces* joined_ = nullptr;  ///< the joined surfaces while they are being drawn; otherwise
                                            ///< null
  gl::Buffer vertices_, large_, counters_, largeGroups_, surfaceGroups_, fans_, clipGroups_,
      roomlessGroups_;
  gl::Buffer left_;  ///< list of the triangles that are too large for the bins
  gl::Texture leftView_;
  gl::Texture vertexView_, largeView_, counterView_, fanView_;
};

}  // namespace simreel::draw
