#pragma once
#include "gl/program.hpp"
#include "sim/contour/border.hpp"
#include "sim/contour/solid.hpp"
#include "sim/contour/totals.hpp"

#include <map>

namespace simreel::sim {

/// Kernels that read the field, made for the kind of its cells.
struct FieldKernels {
  gl::Program classify, raise;
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
  gl::WordsArray squares;  ///< of each point, the square that its contour goes on in
  Totals totals;
  gl::Buffer positions, normals, indices, next;
  gl::Texture positionView, normalView;
  gl::Program tally, list;
  gl::Program freshSheet, sheet;  ///< the second when it is first needed
  std::map<Field::Cells, FieldKernels> kernels;
  Field field;
  bool fresh = true;  ///< normals of the samples are not there yet

  [[nodiscard]] std::int64_t sheetIndices() const { return shape.ceiling ? 12 : 6; }
  [[nodiscard]] std::int64_t firstPoint() const {
    return cornerVertices + static_cast<std::int64_t>(border.positions.size());
  }
  [[nodiscard]] const shader::ContourDraw& found() const { return totals.found(); }

  void checkLimits() const;
  void checkRoom(const char* what, std::int64_t count, int bytes) const;
  void getRoom(std::int64_t points, std::int64_t indexCount);
  void setPlace(const gl::Program& program) const;
  void make();
  void count(const FieldKernels& made);
  [[nodiscard]] const gl::Program& laterSheet();
  void emit(const FieldKernels& made);
  const FieldKernels& kernelsFor(Field::Cells cells);
};

}  // namespace simreel::sim
