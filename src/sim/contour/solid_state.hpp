#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/contour/border.hpp"
#include "sim/contour/solid.hpp"
#include "sim/contour/totals.hpp"

#include <map>

namespace simreel::sim {

struct SolidCeiling {
  gl::Flag<"CEILING"> ceiling;
};
struct SolidVariant {
  gl::Range<"LEVELS", 1, maxSolidLevels> levels;
  SolidCeiling ceiling;
};
/// Part of a kernel interface: members of glsl/contour/samples.glsl.
struct SolidSamples {
  gl::Uniform<"samples", glm::ivec2> samples;
  gl::Uniform<"rowElements", int> rowElements;
  gl::Uniform<"outside", int> outside;
};
struct SolidClassify;
struct SolidCount;
struct SolidSheet;
struct SolidList;
struct SolidRaise;
struct SolidVertices;

/// Kernels that read the field, compiled for its cell format.
struct FieldKernels {
  gl::Kernel<SolidClassify> classify;
  gl::Kernel<SolidRaise> raise;
};

/// Memory and kernels of a solid.
struct Solid::State {
  State(const std::string& label, const SolidShape& given);
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() = default;

  std::string name;
  SolidShape shape;
  glm::ivec2 samples;
  int rowElements;
  std::int64_t corners, elements;
  std::int64_t cornerVertices = 0;
  std::vector<float> heights;
  SolidBorder border;
  std::int64_t pointRoom = 0, indexRoom = 0;
  gl::WordsArray classes, tallies;
  gl::WordsArray squares;  ///< For each contour point, index of the square in which the contour continues.
  Totals totals;
  gl::Buffer positions, normals, indices, next;
  gl::Texture positionView, normalView;
  gl::Kernel<SolidCount> tally;
  gl::Kernel<SolidList> list;
  gl::Kernel<SolidSheet> freshSheet,
      sheet;  ///< Kernels that build the horizontal faces: `freshSheet` for the first build, `sheet`
              ///< (created on first use) for all later builds.
  std::map<Field::Cells, FieldKernels> kernels;
  Field field;
  bool fresh = true;  ///< True while the normals of the samples have not been written.

  [[nodiscard]] std::int64_t sheetIndices() const { return shape.ceiling ? 12 : 6; }
  [[nodiscard]] std::int64_t firstPoint() const {
    return cornerVertices + static_cast<std::int64_t>(border.positions.size());
  }
  [[nodiscard]] const shader::ContourDraw& found() const { return totals.found(); }

  void checkLimits() const;
  void checkRoom(const char* what, std::int64_t count, int bytes) const;
  void getRoom(std::int64_t points, std::int64_t indexCount);
  [[nodiscard]] SolidVariant variant() const {
    return {.levels = static_cast<int>(shape.levels.size()), .ceiling = {shape.ceiling}};
  }
  [[nodiscard]] SolidSamples samplesPart() const {
    return {.samples = samples, .rowElements = rowElements, .outside = shape.outside};
  }
  [[nodiscard]] SolidVertices vertices() const;
  void make();
  void count(const FieldKernels& made);
  void emit(const FieldKernels& made);
  const FieldKernels& kernelsFor(Field::Cells cells);
};

}  // namespace simreel::sim
