#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/visibility.hpp"
#include "sim/core/drawable.hpp"

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace simreel::draw {

/// Finds what of surfaces is nearest at each sample, by kernels: coverage in whole numbers, ties by number.
/// The result does not depend on the order in which the device works.
class TriangleRaster {
 public:
  enum class Into { picture, sunMap, lampMap };
  /// Triangles whose box has no side above `smallPixels` (0 to 64) are drawn by an invocation each, of the
  /// others those of at most `mediumPixels` (to 64) by sixteen, the rest by groups, tile by tile: the same
  /// either way.
  TriangleRaster(Into into, int samples, int smallPixels = smallTriangle(),
                 int mediumPixels = mediumTriangle());

  /// A surface as it was drawn last.
  struct Drawn {
    const sim::Surface* surface = nullptr;
    int firstVertex = 0;
    int firstIndex = 0;  ///< in the list of large ones, times 3
    int maxTriangles = 0;
    unsigned firstId = 0;  ///< of its triangles
    gl::Texture indices;   ///< R32UI texel view
  };

  /// Numbers the triangles: see drawn(). Throws UserError(device) where there are more than numbers.
  void number(const std::vector<const sim::Surface*>& surfaces);
  /// Draws them into what is cleared. The uniform blocks, and for the sun's map the light's place, are bound.
  void draw(const Visibility& into, const MapPart& part = {});
  [[nodiscard]] const std::vector<Drawn>& drawn() const { return drawn_; }
  /// Binds vertices and indices of one of drawn() and says where they are.
  void bind(const Drawn& drawn, const gl::Program& program) const;

 private:
  const gl::Program& vertexProgram(const sim::Surface& surface);
  const gl::Program& program(const char* path, int pass, bool counted, SampleLayout layout);
  void makeVertices(const Visibility& into);
  void run(const char* path, int pass, const Visibility& into, const MapPart& part);
  void runLists(int pass, const Visibility& into, const MapPart& part);

  Into into_;
  int samples_;
  int smallPixels_;
  int mediumPixels_;
  unsigned parts_;  ///< groups that share a large triangle
  std::map<std::pair<bool, bool>, gl::Program> vertexPrograms_;
  std::map<std::tuple<std::string, int, bool, SampleLayout>, gl::Program> programs_;
  GroupCounts groups_;
  std::vector<Drawn> drawn_;
  gl::Buffer vertices_, large_, counters_, largeGroups_, surfaceGroups_;
  gl::Texture vertexView_, largeView_, counterView_;
};

}  // namespace simreel::draw
