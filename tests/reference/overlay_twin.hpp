#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// A picture of four components, top row first: bytes, or premultiplied light and coverage.
template <class T>
struct OverlayPicture {
  glm::ivec2 size{0};
  std::vector<T> pixels;
  [[nodiscard]] T& at(int x, int y) { return pixels.at(static_cast<std::size_t>(y * size.x + x)); }
};
using OverlayBytes = std::array<std::uint8_t, 4>;

/// The declarations of glsl/draw/overlay/field_inputs.glsl and field_view.glsl, under the same names.
struct FieldInputs {
  std::vector<glm::uvec4> words;
  std::vector<glm::vec4> stops;
  glm::ivec2 cells{0};
  int rowWords = 0, firstWord = 0, cellWords = 1, stopCount = 0;
  float rangeLow = 0, rangeFactor = 1;
  int cellKind = 2;
  bool categories = false, colored = false;
  // Position of the field on the picture.
  glm::ivec2 size{0}, base{0};
  glm::vec2 start{0}, perPixel{1}, slope{0};
  bool tiled = false, relief = false, encodes = true, reduces = false, smoothColors = false;
  glm::vec3 border{0};
  float opacity = 1;
};

/// A field on the CPU, from the kernels' source.
class FieldTwin {
 public:
  explicit FieldTwin(FieldInputs inputs) : inputs_(std::move(inputs)) {}
  /// Returns the texels of the averaged field, x fastest: for a coloured field light in rgb and coverage in
  /// a, else the value in every component.
  [[nodiscard]] std::vector<glm::vec4> averaged(glm::ivec2 texels) const;
  /// Makes pixels read these texels instead of cells from now on; inputs.size is their size.
  void setReduced(std::vector<glm::vec4> texels) { reduced_ = std::move(texels); }
  /// Draws the field over a part of a picture (left, top, right, bottom), or behind it.
  void over(OverlayPicture<OverlayBytes>& picture, glm::ivec4 part) const;
  void behind(OverlayPicture<glm::vec4>& light, glm::ivec4 part) const;

 private:
  FieldInputs inputs_;
  std::vector<glm::vec4> reduced_;
};

/// The declarations of glsl/draw/overlay/chart_inputs.glsl, under the same names.
struct ChartInputs {
  std::vector<glm::uvec4> counts;
  int steps = 0;
  float perTop = 1, perColumn = 1;
  glm::vec4 panel{0}, plot{0};
  float unit = 1;
  int curves = 0;
  std::array<glm::vec3, 4> colors{};  ///< linear colours
  float zero = 0, end = 0;
};

/// A chart without its letters, computed on the CPU.
class ChartTwin {
 public:
  explicit ChartTwin(ChartInputs inputs);
  void over(OverlayPicture<OverlayBytes>& picture, glm::ivec4 part) const;
  /// Returns rows as in the kernel's texture: enter, leave, lowest, highest.
  [[nodiscard]] const std::vector<std::array<glm::vec4, 4>>& columns() const { return columns_; }

 private:
  ChartInputs inputs_;
  std::vector<std::array<glm::vec4, 4>> columns_;
};
