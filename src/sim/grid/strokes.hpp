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

/// Brush stroke on a field at a given time: an entry of a scene's list "strokes".
struct StrokeParameters {
  enum class Shape { circle, line, image };
  Shape shape = Shape::circle;
  double at =
      0;  ///< Start time in seconds of scene time. The first state at or after this time shows the stroke.
  bool early = false;  ///< True if the stroke also acts before `at`, from the start of the run.
  double until = 0;    ///< End time in seconds. If it is not after `at`, the stroke paints only once.
  glm::vec3 from{0};   ///< Centre of a circle, start of a line, or top left corner of an image, in cells
                       ///< (third component unused).
  glm::vec3 to{0};     ///< Position of a circle at the time `until`, or end of a line, in cells; by default
                       ///< equal to `from`.
  float radius = 3;    ///< Radius in cells, or half the width of a line.
  std::filesystem::path image;  ///< Image whose bright pixels (level above 127) are painted.
  double value = 1;             ///< Painted value; its meaning depends on the simulation.
  float fraction = 1;           ///< Fraction of the covered cells that are painted; a hash selects these
                                ///< cells.
  std::optional<scene::Animated<glm::vec3>>
      path;  ///< Animated position of a circle in cells; replaces `from` and `to`.
  scene::Animated<float> strength = 1.0F;  ///< Factor on `value`, for fields whose value is an amount.
  /// Declares the fields of a stroke. `max` is the maximum value that may be painted, `valueDoc` the help
  /// text for the value.
  void describe(scene::Fields& fields, double max, const char* valueDoc);
  /// Returns the position of a circle at `time` (seconds), in cells.
  [[nodiscard]] glm::vec2 placeAt(double time) const;
};

/// Grid on which strokes are painted.
struct StrokeGrid {
  glm::ivec2 size{1, 1};  ///< Size of the grid in cells.
  bool torus =
      false;  ///< True if strokes wrap around to the opposite border, false if they end at the border.
  std::string object;  ///< Name of the object and list in messages, such as: life "guns".
};

/// Prepares a scene's strokes for the kernels. Used by all kinds of fields and by the CPU twins.
class Strokes {
 public:
  Strokes() = default;
  /// Loads the images of the strokes. Warns of strokes that are entirely outside the grid. Throws
  /// UserError: the errors of loadPicture(), and usage for a stroke that wraps around a periodic grid too
  /// often.
  Strokes(std::vector<StrokeParameters> strokes, int seed, StrokeGrid grid);

  /// Returns the strokes that paint into the state at `time` (seconds) with step number `step`: those
  /// active after time - seconds and not later than `time`, each with the brush's path in that interval.
  /// The initial state is painted as well, so a stroke at 0 s appears in frame 0. On a periodic grid, a
  /// stroke is returned once for each periodic image that may touch the grid. `numbers`, if given, receives
  /// for each returned stroke the index of the scene's stroke.
  [[nodiscard]] std::vector<shader::Stroke> into(double time, double seconds, long step,
                                                 std::vector<int>* numbers = nullptr) const;
  /// Returns the images as bits, one per pixel, packed into words. Consecutive rows have no padding between
  /// them (shader::Stroke::image).
  [[nodiscard]] const std::vector<std::uint32_t>& imageBits() const { return bits_; }
  /// Returns the bits of the images with four words per element; kernels read them as "stamps".
  [[nodiscard]] std::vector<glm::uvec4> imageElements() const;
  /// Returns true if a stroke paints this cell, according to its shape or image and its fraction. The
  /// result is the same as that of the kernels. Used by the CPU twins.
  [[nodiscard]] bool paints(const shader::Stroke& stroke, glm::ivec2 cell) const;
  /// Returns the cells that a stroke may paint on a grid: first column and row, number of columns and rows.
  /// The numbers are 0 if none exist.
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
  std::vector<Stamp> stamps_;  ///< Location of each stroke's image in `bits_`; one entry per stroke.
  std::vector<std::uint32_t> bits_;
  int seed_ = 0;
  StrokeGrid grid_;
};

/// Part of a kernel interface: members of the uniform `stroke` (glsl/grid/stroke.glsl).
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

/// Part of a kernel interface: uniforms of glsl/grid/stroke_paint.glsl.
struct StrokeUniforms {
  StrokeMembers stroke;
  gl::Uniform<"strokeBox", glm::ivec4> box;
};
[[nodiscard]] StrokeUniforms uniformsOf(const shader::Stroke& stroke, glm::ivec4 box);

}  // namespace simreel::sim
