#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// A picture with four components per pixel, top row first. The components are bytes, or premultiplied
/// light and coverage.
template <class T>
struct OverlayPicture {
  glm::ivec2 size{0};
  std::vector<T> pixels;
  [[nodiscard]] T& at(int x, int y) { return pixels.at(static_cast<std::size_t>(y * size.x + x)); }
};
using OverlayBytes = std::array<std::uint8_t, 4>;

/// Provides the variables that glsl/draw/overlay/field_inputs.glsl and field_view.glsl declare, with the
/// same names.
struct FieldInputs {
  std::vector<glm::uvec4> words;
  std::vector<glm::vec4> stops;
  glm::ivec2 cells{0};
  int rowWords = 0, firstWord = 0, cellWords = 1, stopCount = 0;
  float rangeLow = 0, rangeFactor = 1;
  int cellKind = 2;
  bool categories = false, colored = false;
  // The following variables give the position of the field on the picture.
  glm::ivec2 size{0}, base{0};
  glm::vec2 start{0}, perPixel{1}, slope{0};
  bool tiled = false, relief = false, encodes = true, reduces = false, splined = false, fine = false;
  glm::vec3 border{0};
  float opacity = 1;
};

/// CPU twin of field drawing. It runs the kernels' own source.
class FieldTwin {
 public:
  explicit FieldTwin(FieldInputs inputs) : inputs_(std::move(inputs)) {}
  /// Returns the texels of the averaged field, x fastest. If the field is colored, rgb is light and a is
  /// the normalized value. Otherwise all components are the value.
  [[nodiscard]] std::vector<glm::vec4> averaged(glm::ivec2 texels) const;
  /// Sets averaged texels, which later calls read instead of cells. inputs.size must be the number of these
  /// texels.
  void setReduced(std::vector<glm::vec4> texels) { reduced_ = std::move(texels); }
  /// over() draws the field over a part of a picture (left, top, right, bottom). behind() draws the field
  /// behind the picture.
  void over(OverlayPicture<OverlayBytes>& picture, glm::ivec4 part) const;
  void behind(OverlayPicture<glm::vec4>& light, glm::ivec4 part) const;

 private:
  FieldInputs inputs_;
  std::vector<glm::vec4> reduced_;
};

/// Provides the variables that glsl/draw/overlay/chart_inputs.glsl declares, with the same names.
struct ChartInputs {
  std::vector<glm::uvec4> counts;
  int steps = 0;
  float perTop = 1, perColumn = 1;
  glm::vec4 panel{0}, plot{0};
  float unit = 1;
  int curves = 0;
  std::array<glm::vec3, 4> colors{};  ///< linear RGB
  float zero = 0, end = 0;
};

/// CPU twin of a chart, without the chart's text.
class ChartTwin {
 public:
  explicit ChartTwin(ChartInputs inputs);
  void over(OverlayPicture<OverlayBytes>& picture, glm::ivec4 part) const;
  /// Returns the reduced curves of each pixel column, in the row order of the kernel's texture. The
  /// components are the height at the column's left edge, the height at its right edge, the minimum and the
  /// maximum.
  [[nodiscard]] const std::vector<std::array<glm::vec4, 4>>& columns() const { return columns_; }

 private:
  ChartInputs inputs_;
  std::vector<std::array<glm::vec4, 4>> columns_;
};
