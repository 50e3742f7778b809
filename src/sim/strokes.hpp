#pragma once
#include "gl/program.hpp"
#include "scene/fields.hpp"
#include "sim/shader_code.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// A timed stroke of a brush on a field: an entry of a scene's list "strokes".
struct StrokeParameters {
  enum class Shape { circle, line, image };
  Shape shape = Shape::circle;
  double at = 0;     ///< s of scene time when it begins
  double until = 0;  ///< s when it ends; not after `at`: one step only
  glm::vec3 from{
      0};  ///< cells (third unused): middle of the circle, start of the line, top left of the image
  glm::vec3 to{0};   ///< cells: where a circle moves to by `until`, end of the line; not given: `from`
  float radius = 3;  ///< cells; of a line half its width
  std::filesystem::path image;  ///< light pixels (level above 127) are painted
  double value = 1;             ///< what is painted; each simulation says what it means
  float share = 1;              ///< of the cells within reach, picked by hash
  /// `most`: greatest value that may be painted; `valueDoc`: what it means.
  void describe(scene::Fields& fields, double most, const char* valueDoc);
};

/// The strokes of a scene as the kernels want them. Common to every field; the CPU twins use it too.
class Strokes {
 public:
  Strokes() = default;
  /// Loads the images of stamps. Throws UserError for one that cannot be read.
  Strokes(std::vector<StrokeParameters> strokes, int seed);

  /// Those that paint in the step from `time` to `time + seconds`, with where the brush goes in it. A
  /// stroke of no duration paints in the one step that holds `at`.
  [[nodiscard]] std::vector<shader::Stroke> during(double time, double seconds, long step) const;
  /// Bits of the stamps, one per pixel in words, rows packed without gaps (shader::Stroke::image).
  [[nodiscard]] const std::vector<std::uint32_t>& imageBits() const { return bits_; }
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
  std::vector<StrokeParameters> strokes_;
  std::vector<Stamp> stamps_;  ///< one per stroke
  std::vector<std::uint32_t> bits_;
  int seed_ = 0;
};

/// Sets the uniforms of glsl/common/stroke_paint.glsl.
void setStroke(const gl::Program& program, const shader::Stroke& stroke, glm::ivec4 box);

}  // namespace simreel::sim
