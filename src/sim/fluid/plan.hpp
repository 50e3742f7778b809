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

/// CPU-side setup of a fluid: obstacle cells, multigrid weights, and the parameters of each substep. Used
/// by the GPU simulation and by its CPU twin.
class FluidPlan {
 public:
  /// Brushes that act in the same substep, and the strokes that they belong to.
  struct Brushes {
    std::vector<shader::FluidBrush> brushes;
    std::vector<shader::Stroke> strokes;
  };

  /// Reads the images of the strokes. Reads the images of the obstacles unless `pictures` is given. Throws
  /// UserError(usage) if the viscosity makes the substeps unstable or if more than maxBrushes brushes act
  /// in one substep.
  FluidPlan(FluidParameters parameters, const std::string& object, int seed, double frameSeconds,
            std::vector<PictureDistances> pictures = {});

  [[nodiscard]] const FluidParameters& parameters() const { return parameters_; }
  [[nodiscard]] glm::ivec2 size() const { return parameters_.size; }
  /// Returns the number of cells, including the ring around the grid.
  [[nodiscard]] int elements() const { return (size().x + 2) * (size().y + 2); }
  [[nodiscard]] int substeps() const { return substeps_; }
  /// Returns the speed in cells/s above which the flow is too fast: the expected speed, or 10% more if the
  /// scene leaves it out, because dye that lags by less than that is not visible.
  [[nodiscard]] float fastest() const;
  /// Returns a warning for a flow that reaches a speed (cells/s) above fastest().
  [[nodiscard]] std::string speedRemark(float reached) const;
  /// Returns the number of dye advection passes per substep; 0 if no stroke sets dye.
  [[nodiscard]] int dyePasses() const { return dyePasses_; }
  /// Returns the multigrid hierarchy, with the face weights of the initial state.
  [[nodiscard]] const FluidLevels& levels() const { return stillSolids()->levels(); }
  /// Returns the obstacles after `step` substeps of the frame that starts at `time` (seconds). It is always
  /// the same object if no obstacle moves.
  [[nodiscard]] std::shared_ptr<const FluidSolids> solidsAt(double time, int step) const;
  [[nodiscard]] const Strokes& strokes() const { return strokes_; }

  /// Returns the flow before painting and projection, including the ring of cells.
  [[nodiscard]] std::vector<glm::vec4> firstFlow(double time) const;
  /// Returns the uniform block of substep `step` (counted from 1) of the frame that starts at `time`
  /// (seconds).
  [[nodiscard]] shader::FluidStep stepAt(double time, int step) const;
  /// Returns the phase, 0 to 1, of the ripples that move along flow lines at `time` (seconds).
  [[nodiscard]] float linePhase(double time) const;
  /// Returns the brushes that paint into the state after `step` substeps of the frame that starts at `time`
  /// (seconds). Throws UserError(usage) for more than maxBrushes.
  [[nodiscard]] Brushes brushesAt(double time, int step) const;

 private:
  FluidParameters parameters_;
  std::string object_;
  double frameSeconds_;
  int substeps_ = 1, dyePasses_ = 1;
  std::vector<PictureDistances> pictures_;  ///< Distances to the images of the obstacles; one entry per
                                            ///< obstacle.
  Strokes strokes_;
  /// Returns the obstacles at time 0. They are created on first use, so that a plan made only for
  /// validation allocates no memory per cell.
  [[nodiscard]] const std::shared_ptr<const FluidSolids>& stillSolids() const;

  mutable std::shared_ptr<const FluidSolids> still_;
};

}  // namespace simreel::sim
