#pragma once
#include "gl/kernel/fields.hpp"
#include "scene/value/animated.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/shader_code.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// A timed stroke of a brush on a field: an entry of a scene's list "strokes".
struct StrokeParameters {
  enum class Shape { circle, line, image };
  Shape shape = Shape::circle;
  double at = 0;     ///< s of scene time when it begins; the first state at or after it shows it
  double until = 0;  ///< s when it ends; not after `at`: it paints once
  glm::vec3 from{
      0};  ///< cells (third unused): middle of the circle, start of the line, top left of the image
  glm::vec3 to{0};   ///< cells: where a circle moves to by `until`, end of the line; not given: `from`
  float radius = 3;  ///< cells; of a line half its width
  std::filesystem::path image;                     ///< light pixels (level above 127) are painted
  double value = 1;                                ///< what is painted; each simulation says what it means
  float fraction = 1;                              ///< of the cells within reach, picked by hash
  std::optional<scene::Animated<glm::vec3>> path;  ///< cells: where a circle is, instead of `from` and `to`
  scene::Animated<float> strength = 1.0F;          ///< factor on `value`, of fields where that is an amount
  /// `most`: greatest value that may be painted; `valueDoc`: what it means.
  void describe(scene::Fields& fields, double max, const char* valueDoc);
  /// Where a circle is at `time` (s), cells.
  [[nodiscard]] glm::vec2 placeAt(double time) const;
};

/// The grid that strokes are painted on.
struct StrokeGrid {
  glm::ivec2 size{1, 1};  ///< cells
  bool torus = false;     ///< strokes go on at the opposite border; else they end at it
  std::string object;     ///< whose it is, as messages call it: life "guns"
};

/// The strokes of a scene as the kernels want them. Common to every field; the CPU twins use it too.
class Strokes {
 public:
  Strokes() = default;
  /// Loads the images of stamps; warns of strokes that paint nothing because they lie wholly outside.
  /// Throws UserError for an image that cannot be read (what loadPicture says) and usage for a stroke that
  /// goes round a torus more often than is sensible.
  Strokes(std::vector<StrokeParameters> strokes, int seed, StrokeGrid grid);

  /// Those that paint into the state of `time` (s), number `step`, to which the step before took `seconds`:
  /// what is due after time - seconds and no later than `time`, with where the brush went in between. The
  /// first state of a run is painted as well, so a stroke at 0 is in frame 0. On a torus a stroke stands
  /// here once for each of its images that may reach the grid.
  /// `numbers`, where given, gets for each of them which stroke of the scene it is.
  [[nodiscard]] std::vector<shader::Stroke> into(double time, double seconds, long step,
                                                 std::vector<int>* numbers = nullptr) const;
  /// Bits of the stamps, one per pixel in words, rows packed without gaps (shader::Stroke::image).
  [[nodiscard]] const std::vector<std::uint32_t>& imageBits() const { return bits_; }
  /// The same, four words an element: what kernels read as "stamps".
  [[nodiscard]] std::vector<glm::uvec4> imageElements() const;
  /// Whether a stroke paints this cell: reach or stamp, and share. What the kernels do, for twins.
  [[nodiscard]] bool paints(const shader::Stroke& stroke, glm::ivec2 cell) const;
  /// Cells that it may paint on a grid: first column and row, and how many of each; none: 0, 0.
  [[nodiscard]] static glm::ivec4 box(const shader::Stroke& stroke, glm::ivec2 grid);
  [[nodiscard]] bool empty() const { return strokes_.empty(); }

 private:
  struct Stamp {
    int firstWord = 0;
    glm::ivec2 size{0, 0};
  };
  void check(std::size_t index) const;
  void addImages(std::vector<shader::Stroke>& all, const shader::Stroke& stroke) const;

  std::vector<StrokeParameters> strokes_;
  std::vector<Stamp> stamps_;  ///< one per stroke
  std::vector<std::uint32_t> bits_;
  int seed_ = 0;
  StrokeGrid grid_;
};

/// Members of the uniform `stroke` (glsl/grid/stroke.glsl).
struct StrokeMembers {
  gl::Uniform<"stroke.from", glm::vec2> from;
  gl::Uniform<"stroke.to", glm::vec2> to;
  gl::Uniform<"stroke.radius2", float> radius2;
  gl::Uniform<"stroke.perLength2", float> perLength2;
  gl::Uniform<"stroke.value", float> value;
  gl::Uniform<"stroke.seed", int> seed;
  gl::Uniform<"stroke.picked", int> picked;
  gl::Uniform<"stroke.imageWord", int> imageWord;
  gl::Uniform<"stroke.imageFrom", glm::ivec2> imageFrom;
  gl::Uniform<"stroke.imageSize", glm::ivec2> imageSize;
};
[[nodiscard]] StrokeMembers uniformsOf(const shader::Stroke& stroke);

/// Uniforms of glsl/grid/stroke_paint.glsl, a part of the interfaces of kernels that paint.
struct StrokeUniforms {
  StrokeMembers stroke;
  gl::Uniform<"strokeBox", glm::ivec4> box;
};
[[nodiscard]] StrokeUniforms uniformsOf(const shader::Stroke& stroke, glm::ivec4 box);

}  // namespace simreel::sim
