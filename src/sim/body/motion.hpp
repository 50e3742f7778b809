#pragma once
#include "sim/body/parameters.hpp"
#include "sim/core/carrier.hpp"

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// A body's bones at any time, on the CPU and from the time alone, which counts in steps of 2^-24 s: what
/// is asked for by sums that round differently gets the same bits. Not for several threads at once.
class BodyMotion {
 public:
  /// `name` stands in messages. Throws what loadFigure() throws, and UserError(usage) for an animation or a
  /// bone that the file does not have.
  BodyMotion(const std::string& name, const BodyParameters& parameters);

  [[nodiscard]] const Figure& figure() const { return *figure_; }
  /// From the space of a node to the world at `time` (s).
  [[nodiscard]] const glm::dmat4& nodeAt(int node, double time) const {
    return poseAt(time)[static_cast<std::size_t>(node)];
  }
  /// That of the bone of this name; UserError(usage) where there is none.
  [[nodiscard]] int boneNamed(const std::string& bone) const;
  /// What takes each joint's vertices from bind to the world at `time`: three rows of a matrix a joint.
  [[nodiscard]] std::vector<glm::vec4> rowsAt(double time) const;

 private:
  struct Pose {
    double time;
    std::vector<glm::dmat4> nodes;
  };
  [[nodiscard]] const std::vector<glm::dmat4>& poseAt(double time) const;
  [[nodiscard]] std::vector<glm::dmat4> pose(double time) const;
  [[nodiscard]] double motionTime(double time) const;

  std::string name_;
  BodyParameters parameters_;
  std::shared_ptr<const Figure> figure_;
  const FigureAnimation* animation_ = nullptr;
  std::vector<int> keyed_;             ///< node of each of the parameters' bones
  mutable std::array<Pose, 2> poses_;  ///< the last two that were asked for: a frame's beginning and end
  mutable std::size_t newest_ = 0;
};

}  // namespace simreel::sim
