#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/triangles/triangle_bins.hpp"
#include "draw/exact/visibility.hpp"
#include "sim/core/drawable.hpp"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
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

/// A lamp's shadow map to draw, seen as a picture is.
struct MapFace {
  const gl::Buffer* views = nullptr;
  std::size_t view = 0;  ///< where its shader::ExactView is (bytes)
  MapPart part;
};

/// Finds what of surfaces is nearest at each sample, by kernels: coverage in whole numbers, ties by number.
/// The result does not depend on the order in which the device works.
class TriangleRaster {
 public:
  enum class Into { picture, sunMap, lampMap };
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
    /// Whether a surface has holes, and then what glsl/draw/exact/triangles/cutout.glsl reads.
    std::function<bool(const sim::Surface&)> cut = {};
    std::function<void(const sim::Surface&, const gl::Program&)> tell = {};
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
  /// Binds vertices and indices of one of drawn() and says where they are.
  void bind(const Drawn& drawn, const gl::Program& program) const;
  /// The same of joined surfaces, which were drawn last.
  void bindWhole(const gl::Program& program) const { bind(whole_, program); }

 private:
  const gl::Program& vertexProgram(const sim::Surface& surface, bool parallel);
  /// What suits a program.
  struct Variant {
    std::string path;
    int pass = 0;
    SampleKind layout;
    bool counted = false;  ///< a surface says itself how many triangles it has
    bool clips = false;    ///< those are drawn that are not clipped yet
    bool bins = false;     ///< small ones are binned
    bool joined = false;   ///< surfaces are
    bool faces = false;    ///< of lamps' maps, all in one go
    bool cut = false;      ///< the surface has holes
    bool grid = false;     ///< and is a grid
    bool layer = false;    ///< it is blended
    // NOLINTNEXTLINE(modernize-use-nullptr): none is written
    auto operator<=>(const Variant&) const = default;
  };
  const gl::Program& program(const Variant& variant);
  void drawAsked(const Visibility& into, const MapPart& part);
  void drawNearestAsked(const Visibility& into, const MapPart& part);
  void drawNumbersAsked(const Visibility& into);
  void tellLayers(const gl::Program& kernel) const;
  void makeVertices(const Visibility& into);
  void clipLarge(const Visibility& into);
  void prepareLarge(glm::ivec2 size);
  void reserveLists(std::size_t draws, std::int64_t triangles, int fans);
  void tell(const gl::Program& kernel, const Visibility& into, const MapPart& part) const;
  void runFaces(const char* path, int pass, const Visibility& into, bool clips);
  void fillGroups();
  void drawBinned(const Visibility& into);
  [[nodiscard]] gl::Defines intoDefines() const;
  void run(const char* path, int pass, const Visibility& into, bool clips = false);
  void runLists(int pass, const Visibility& into);

  Into into_;
  Fragments fragments_;
  int samples_;
  int smallPixels_;
  int fanRoom_;
  int mediumPixels_;
  int binRoom_;
  bool binned_ = false;  ///< those that are being drawn
  std::map<std::array<bool, 3>, gl::Program> vertexPrograms_;
  std::map<Variant, gl::Program> programs_;
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
