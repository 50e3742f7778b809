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

/// Vertices that a surface has room for, and triangles.
[[nodiscard]] inline int verticesOf(const sim::Surface& surface) {
  return std::max(surface.vertexCount, surface.vertexRoom);
}
[[nodiscard]] inline int maxTrianglesOf(const sim::Surface& surface) {
  const std::size_t indices = surface.arguments == nullptr ? static_cast<std::size_t>(surface.indexCount)
                                                           : surface.indices->bytes() / sizeof(GLuint);
  return static_cast<int>(indices / 3);
}

/// Lists of a mesh's triangles on the GPU, one behind the other.
struct TriangleLists {
  const gl::Texture* places = nullptr;   ///< of the mesh in the world (m), RGBA32F
  const gl::Texture* indices = nullptr;  ///< R32UI, 3 of each triangle
  const gl::Texture* numbers = nullptr;  ///< R32UI
  const gl::Buffer* counts = nullptr;    ///< of each list
  int room = 0;                          ///< of each
};

/// Fields of glsl/draw/exact/triangles/surface_triangle.glsl.
struct TriangleSource {
  gl::In<"vertices"> vertices;
  gl::In<"places"> places;  ///< of a merged mesh, instead
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

/// Finds what of surfaces is nearest at each sample, by kernels: coverage in whole numbers, ties by number.
/// The result does not depend on the order in which the device works.
class TriangleRaster {
 public:
  using Into = Target;
  /// Triangles whose box has no side above `smallPixels` (0 to 64) are drawn by an invocation each, of the
  /// others those of at most `mediumPixels` (to 64) by sixteen, the rest by groups, tile by tile: the same
  /// either way. Of those `fanRoom` are clipped once, for all invocations that draw them; 128 bytes each.
  /// `bins`: small ones go by tiles where samples lie apart, but for lamps' maps and where they are very
  /// many.
  TriangleRaster(Into into, int samples, int smallPixels = smallTriangle(), int fanRoom = fansOfTriangles(),
                 int mediumPixels = mediumTriangle(), int binRoom = binnedTriangles());

  /// A surface as it was drawn last.
  struct Drawn {
    const sim::Surface* surface = nullptr;
    int firstVertex = 0;
    int firstIndex = 0;  ///< in the list of large ones, times 3
    int maxTriangles = 0;
    unsigned firstId = 0;  ///< of its triangles
    int firstFan = 0;      ///< of its clipped triangles,
    int fans = 0;          ///< and for how many there is room
    gl::Texture indices;   ///< R32UI texel view
    int list = 0;          ///< of the triangles of a lamp's map,
    MapFace face;          ///< and where that is
  };

  /// What cuts holes into surfaces and tells layers of blended ones apart; all must outlive what draws.
  struct Fragments {
    /// Whether a surface has holes, and then what says where.
    std::function<bool(const sim::Surface&)> cut = {};
    std::function<Cutout(const sim::Surface&)> holes = {};
    const sim::Surface* only = nullptr;  ///< of which a lamp's lists of triangles are
    bool layers = false;                 ///< what is behind `before` (null: all) is drawn,
    const Visibility* before = nullptr;
    const Visibility* behind = nullptr;  ///< and not behind that
  };
  /// One that draws each sample by itself, whole triangles by groups: for surfaces that Fragments tells
  /// about.
  static TriangleRaster ofFragments(Into into, int samples) { return {into, samples, 0, 0, 0, 0}; }
  void tellFragments(Fragments fragments) { fragments_ = std::move(fragments); }

  /// Numbers the triangles, from `firstId` on: see drawn(). Throws UserError(device) where there are more
  /// than numbers.
  void number(const std::vector<const sim::Surface*>& surfaces, unsigned firstId = 0);
  /// For lamps' maps instead: face i shows the triangles of list i. All of it holds until they are drawn.
  void number(const TriangleLists& lists, const std::vector<MapFace>& faces);
  /// The same, of which `views` holds those of all maps one behind the other, face 0's number `first`: they
  /// are drawn all in one go, as cards have it best.
  void number(const TriangleLists& lists, const std::vector<MapFace>& faces, const gl::Buffer& views,
              int first);
  /// Draws them into what is cleared. The uniform blocks, and for the sun's map the light's place, are
  /// bound; into lamps' maps, it binds the faces' views.
  void draw(const Visibility& into, const MapPart& part = {});
  /// The two halves of draw() into a picture: what is nearest, before anything draws numbers; the numbers,
  /// when everything has drawn what is nearest.
  void drawNearest(const Visibility& into);
  void drawNumbers(const Visibility& into);
  /// The same surfaces, joined, in one go.
  void drawJoined(const Visibility& into, const JoinedSurfaces& joined);
  [[nodiscard]] const std::vector<Drawn>& drawn() const { return drawn_; }
  /// For kernels that read the triangles of one of drawn().
  [[nodiscard]] TriangleSource source(const Drawn& drawn) const;
  /// The same of joined surfaces, which were drawn last.
  [[nodiscard]] TriangleSource wholeSource() const { return source(whole_); }

 private:
  enum class Step { small, medium, clip, large };
  void drawAsked(const Visibility& into, const MapPart& part);
  void drawNearestAsked(const Visibility& into, const MapPart& part);
  void drawNumbersAsked(const Visibility& into);
  void makeVertices(const Visibility& into);
  void clipLarge(const Visibility& into);
  void prepareLarge(glm::ivec2 size);
  void reserveLists(std::size_t draws, std::int64_t triangles, int fans);
  [[nodiscard]] RasterTriangles raster(const Drawn& drawn, const Visibility& into) const;
  [[nodiscard]] RasterVariant variant(const Visibility& into, int pass) const;
  /// Runs a step's kernel by `dispatch`, a function of it and of what it is given.
  template <class Dispatch>
  void runKernel(Step step, bool clips, const RasterVariant& variant, const RasterTriangles& raster,
                 const Drawn& drawn, const Dispatch& dispatch);
  void runFaces(Step step, int pass, const Visibility& into, bool clips);
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
  bool binned_ = false;  ///< those that are being drawn
  gl::Kernels<VertexKernel> vertexKernels_;
  gl::Kernels<SmallTriangles> small_;
  gl::Kernels<MediumTriangles> medium_;
  gl::Kernels<ClipTriangles> clip_;
  gl::Kernels<LargeTriangles> largeOnes_;
  GroupCounts groups_;
  TriangleBins bins_;
  TriangleLists lists_;                    ///< that lamps' maps show
  const gl::Buffer* faceViews_ = nullptr;  ///< of all those maps, where they are drawn in one go
  int firstView_ = 0;
  std::vector<Drawn> drawn_;
  std::span<Drawn> asked_;                  ///< all of those, or what they are joined to,
  Drawn whole_;                             ///< which is that,
  const JoinedSurfaces* joined_ = nullptr;  ///< of these
  gl::Buffer vertices_, large_, counters_, largeGroups_, surfaceGroups_, fans_, clipGroups_,
      roomlessGroups_;
  gl::Buffer left_;  ///< of large ones, what is not binned
  gl::Texture leftView_;
  gl::Texture vertexView_, largeView_, counterView_, fanView_;
};

}  // namespace simreel::draw
