#pragma once
#include "gl/buffer.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/simulation.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Interface of glsl/tubes/tube.comp.
struct TubeKernel {
  static constexpr auto file = "tubes/tube.comp";
  gl::Uniform<"lines", int> lines;
  gl::Uniform<"lineRoom", int> room;
  gl::Uniform<"radius", float> radius;
  gl::Uniform<"taperFirst", float> taperFirst;
  gl::Uniform<"taperLast", float> taperLast;
  gl::Uniform<"fade", float> fade;
  gl::Uniform<"paletteSize", int> paletteSize;
  gl::Uniforms<"circle", glm::vec2, 6> circle;
  gl::In<"points"> points;
  gl::In<"SpanBlock"> spans;
  gl::In<"palette"> palette;
  gl::Out<"vertices"> vertices;
  gl::Out<"normals"> normals;
  gl::Out<"colors"> colors;
};

/// Tubes around lines of points, in one mesh that a kernel writes in each frame.
class Tubes {
 public:
  static constexpr int sides = 6;

  /// Appearance of the tubes.
  struct Look {
    float radius = 0.01F;  ///< radius in metres
    /// Number of points over which the tube widens from its first point and narrows to its last point; 0
    /// for none.
    float taperFirst = 0, taperLast = 0;
    float fade = 0;  ///< fraction by which the colour is darkened at the last point
  };

  Tubes() = default;
  /// Allocates memory for `lines` tubes of up to `points` points. `stops` are evenly spaced colours for w =
  /// 0 to w = 1 of a point; there must be at least one.
  Tubes(const std::string& name, int lines, int points, const std::vector<glm::vec3>& stops, bool fast);

  /// Computes the mesh. `points` has `points` elements per line: xyz is the position in metres, w the
  /// position in the colours. `spans` has an ivec4 per tube: x and y are the indices of the first and last
  /// point within the line, z is the line. There is no tube if y is less than x.
  void make(const gl::Vec4Array& points, const gl::Buffer& spans, const Look& look);
  /// Returns the arguments of the indirect draw (five words). A kernel may write the number of indices to
  /// draw into them: indicesPerTube() for each tube.
  [[nodiscard]] const gl::Buffer& arguments() const { return arguments_; }
  [[nodiscard]] int indicesPerTube() const { return indexCount_ / std::max(lines_, 1); }
  /// Returns the surface, whose pointers are valid while this object exists. Its colours are multiplied by
  /// the material's colour.
  [[nodiscard]] Surface surface(const scene::Material& material) const;
  /// Reads the mesh back and leaves out triangles that have no area.
  [[nodiscard]] MeshTable table() const;

  /// Returns the number of bytes of memory that tubes need.
  [[nodiscard]] static double bytesFor(int lines, int points) {
    return static_cast<double>(lines) * (points + 2) * sides * (3 * 16 + 8 + 24);
  }

 private:
  int lines_ = 0, points_ = 0;
  gl::Vec4Array vertices_, normals_, colors_, palette_;
  int paletteSize_ = 1;
  gl::Buffer uvs_, indices_, arguments_;
  gl::Texture uvView_;
  int indexCount_ = 0;
  std::vector<glm::vec2> circle_;
  gl::Kernel<TubeKernel> kernel_;
};

}  // namespace simreel::sim
