#pragma once
#include "sim/contour/solid.hpp"

#include <functional>
#include <vector>

#include <glm/vec2.hpp>

/// CPU twin of a field's solid. It processes squares one after the other and stores polygons as lists. It
/// uses the kernels' vertex numbering and triangle order and equals the GPU bit for bit.
struct SolidTwin {
  /// `value`: function that returns the value of the field's cell (x, y).
  SolidTwin(const simreel::sim::SolidShape& shape, const std::function<float(int x, int y)>& value);

  simreel::sim::MeshTable mesh;
  simreel::sim::ContourLines lines;

  /// Returns the class of a sample, which is the number of levels that the sample's value reaches. The
  /// field's cells begin at sample (1, 1).
  [[nodiscard]] int classAt(int x, int y) const;

 private:
  struct Edge {
    glm::ivec2 at, along;
    int from, to;    ///< classes of the two samples
    unsigned first;  ///< index of the edge's first point
    [[nodiscard]] unsigned pointOf(int level) const {
      return first + static_cast<unsigned>(level - std::min(from, to) - 1);
    }
  };
  void addCorners();
  void addPoints();
  void addPoint(const Edge& edge, int level);
  void addSquares();
  void addWalls(int x, int y);
  void addFaces(int x, int y);
  void addFace(const std::vector<unsigned>& face);
  [[nodiscard]] const Edge& edgeOf(int x, int y, int side) const;
  [[nodiscard]] float valueAt(int x, int y) const;
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y * samples_.x + x);
  }

  simreel::sim::SolidShape shape_;
  std::function<float(int, int)> value_;
  glm::ivec2 samples_;
  unsigned corners_ = 0, firstPoint_ = 0;
  std::vector<int> classes_;
  std::vector<Edge> right_, down_;  ///< edges to the right of and below each sample
  std::vector<unsigned> sheets_, walls_, faces_;
};
