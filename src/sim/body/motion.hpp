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

/// Computes the transforms of a body's bones at any time, on the CPU. Times are rounded to multiples of
/// 2^-24 s, so that callers whose sums are rounded differently get the same bits. Not thread-safe.
class BodyMotion {
 public:
  /// `name` appears in messages. Throws the errors of loadFigure(), and UserError(usage) for an unknown
  /// animation or bone.
  BodyMotion(const std::string& name, const BodyParameters& parameters);

  [[nodiscard]] const Figure& figure() const { return *figure_; }
  /// Returns the transform from node space to world space at `time` (seconds).
  [[nodiscard]] const glm::dmat4& nodeAt(int node, double time) const {
    return poseAt(time)[static_cast<std::size_t>(node)];
  }
  /// Returns the node index of the bone with this name; throws UserError(usage) for an unknown name.
  [[nodiscard]] int boneNamed(const std::string& bone) const;
  /// Returns for each joint the transform of the vertices that follow it, from the bind pose to world space
  /// at `time`, as three matrix rows.
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
  std::vector<int> keyed_;             ///< node index of each bone in BodyParameters::bones
  mutable std::array<Pose, 2> poses_;  ///< cache of the last two poses: those at the beginning and the end
                                       ///< of a frame
  mutable std::size_t newest_ = 0;
};

}  // namespace simreel::sim
