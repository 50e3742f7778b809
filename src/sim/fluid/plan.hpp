#pragma once
#include "sim/fluid/model.hpp"
#include "sim/fluid/parameters.hpp"
#include "sim/fluid/solids.hpp"

#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Everything of a fluid that is decided on the CPU: the obstacles' cells, the multigrid's weights, what
/// each substep is told. Shared by the GPU simulation and its CPU twin.
class FluidPlan {
 public:
  /// Brushes that are at work in the same substep, and the strokes that they are.
  struct Brushes {
    std::vector<shader::FluidBrush> brushes;
    std::vector<shader::Stroke> strokes;
  };

  /// Reads the obstacles' images unless they are given, and the strokes' images. Throws UserError(usage)
  /// for substeps that the viscosity makes unstable, or for more brushes at once than maxBrushes.
  FluidPlan(FluidParameters parameters, const std::string& object, int seed, double frameSeconds,
            std::vector<PictureDistances> pictures = {});

  [[nodiscard]] const FluidParameters& parameters() const { return parameters_; }
  [[nodiscard]] glm::ivec2 size() const { return parameters_.size; }
  /// Of an array of cells and the ring around them.
  [[nodiscard]] int elements() const { return (size().x + 2) * (size().y + 2); }
  [[nodiscard]] int substeps() const { return substeps_; }
  /// Passes of dye in each substep; none where no stroke sets any.
  [[nodiscard]] int dyePasses() const { return dyePasses_; }
  /// The multigrid's grids; their weights are those of the start where obstacles move.
  [[nodiscard]] const FluidLevels& levels() const { return stillSolids()->levels(); }
  /// The obstacles after `step` substeps of the frame that starts at `time` (s); always the same object
  /// where none moves.
  [[nodiscard]] std::shared_ptr<const FluidSolids> solidsAt(double time, int step) const;
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }

  /// The flow before anything is painted or projected, with its ring.
  [[nodiscard]] std::vector<glm::vec4> firstFlow(double time) const;
  /// Of substep `step` (from 1) of the frame that starts at `time` (s).
  [[nodiscard]] shader::FluidStep stepAt(double time, int step) const;
  /// Where the ripples are that run along lines of flow at `time` (s), in turns, 0 to 1.
  [[nodiscard]] float linePhase(double time) const;
  /// What is painted into the state after `step` substeps of the frame that starts at `time` (s). Throws
  /// UserError(usage) for more than maxBrushes.
  [[nodiscard]] Brushes brushesAt(double time, int step) const;

 private:
  FluidParameters parameters_;
  std::string object_;
  double frameSeconds_;
  int substeps_ = 1, dyePasses_ = 1;
  std::vector<PictureDistances> pictures_;  ///< of the obstacles
  Strokes strokes_;
  /// What stands at 0 s. Made when it is first asked for: a plan that is only checked takes no memory for
  /// each cell.
  [[nodiscard]] const std::shared_ptr<const FluidSolids>& stillSolids() const;

  mutable std::shared_ptr<const FluidSolids> still_;
};

}  // namespace simreel::sim
