#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/cloth/skin_hold.hpp"
#include "sim/cloth/thin.hpp"
#include "sim/touch/touch.hpp"

#include <string>

namespace simreel::sim {

/// Part of a kernel interface: inputs of glsl/cloth/kernel.glsl in one substep.
struct ClothPart {
  gl::Uniform<"size", glm::ivec2> size;
  gl::Block<"StepBlock", shader::ClothStep> step;
  gl::InOut<"StatusBlock"> status;
  TouchPart touch = {};
};

struct ClothStepKernel;
struct ClothRelaxKernel;
struct ClothLinesKernel;
struct ClothSolveKernel;
struct ClothSettleKernel;
struct ClothThinKernel;
struct ClothRelaxedArrays;

/// Owns the GPU state of a sheet of particles and dispatches the kernels of a substep.
class ClothKernels {
 public:
  /// Keeps a pointer to `plan`, which must outlive this object.
  ClothKernels(const std::string& name, const ClothPlan& plan, const TouchVariant& touch, bool fast);

  /// Prepares the frame from time `begin` to `end` (seconds).
  void beginFrame(double begin, double end) { hold_.beginFrame(plan_->skinPins(), begin, end); }
  /// Computes the state after a substep; finish() makes it the current state.
  void predict(int substep, const ClothPart& part);
  /// Corrects the predicted state of the particles that contact has pushed since predict().
  void settle(const ClothPart& part) const;
  void finish();

  [[nodiscard]] gl::Vec4Array& positions() { return positions_[0]; }
  [[nodiscard]] const gl::Vec4Array& positions() const { return positions_[0]; }
  [[nodiscard]] gl::Vec4Array& nextPositions() { return positions_[1]; }
  [[nodiscard]] const gl::Vec4Array& nextPositions() const { return positions_[1]; }
  /// Returns the most recent velocities: within a substep, the predicted ones.
  [[nodiscard]] gl::Vec4Array& velocities() { return velocities_[hasTrends() && predicted_ ? 1 : 0]; }
  [[nodiscard]] const gl::Vec4Array& velocities() const {
    return velocities_[hasTrends() && predicted_ ? 1 : 0];
  }
  /// Returns the trend of each particle: its velocity change by constraints in the previous substep.
  /// ledTo() of glsl/cloth/motion.glsl extrapolates it.
  [[nodiscard]] gl::Vec4Array& trends() { return trends_; }
  [[nodiscard]] const gl::Vec4Array& trends() const { return trends_; }
  /// Returns true if the constraints have a trend. Constraints that keep energy act as forces and have
  /// none.
  [[nodiscard]] bool hasTrends() const { return constrained_ && !keeps_; }

 private:
  void makeKernels(const TouchVariant& touch, bool fast);
  [[nodiscard]] gl::Kernel<ClothSolveKernel> lineSolver(const gl::Defines& defines,
                                                        const TouchVariant& touch, bool rows) const;
  void dispatchStep(const ClothPart& part) const;
  void constrain(const ClothPart& part) const;
  void solve(const gl::Kernel<ClothSolveKernel>& kernel, const ClothPart& part, glm::ivec2 items) const;
  [[nodiscard]] ClothRelaxedArrays relaxed(const gl::Vec4Array& from, const gl::Vec4Array& to) const;
  void relaxInLines(const ClothPart& part) const;
  void relaxInTiles(const ClothPart& part) const;
  void dispatchTiles(const gl::Kernel<ClothRelaxKernel>& kernel, int halo,
                     const ClothRelaxKernel& given) const;
  void pushThin(const ClothPart& part) const;
  [[nodiscard]] int lineCount(glm::ivec2 reach) const;
  [[nodiscard]] bool bends() const { return relaxedFamilies(plan_->parameters()).size() > 2; }

  const ClothPlan* plan_;
  glm::ivec2 size_;
  bool constrained_;  ///< true for XPBD constraints, false for springs
  bool keeps_;        ///< true if the constraints keep energy (glsl/cloth/keeping.glsl)
  /// True if an invocation relaxes a line of pairs (constrain_lines.comp), false if it relaxes a single
  /// pair. The first dispatch over lines also integrates the particles.
  bool inLines_ = gl::memoryPath() == gl::MemoryPath::texel;
  bool predicted_ = false;       ///< true between predict() and finish()
  gl::Vec4Array positions_[2];   ///< current positions, and the output of the next substep
  gl::Vec4Array between_;        ///< positions after the diagonal constraints and before the bending
                                 ///< constraints
  gl::Vec4Array velocities_[2];  ///< current velocities, and for constraints with trends also the output of
                                 ///< the next substep
  gl::Vec4Array trends_;
  gl::Vec4Array left_;  ///< for a cloth in contact: the predicted positions before contact pushed the
                        ///< particles
  SkinHold hold_;
  ThinColliders thin_;
  gl::Kernel<ClothStepKernel> step_;
  gl::Kernel<ClothRelaxKernel> relax_[2];  ///< [0] relaxes the diagonal pairs, [1] the bending pairs
  gl::Kernel<ClothLinesKernel> lines_[2];  ///< [0] processes the first spring family, [1] the other
                                           ///< families
  gl::Kernel<ClothSolveKernel> rows_, columns_;
  gl::Kernel<ClothSettleKernel> settle_;
  gl::Kernel<ClothThinKernel> findThin_;
};

}  // namespace simreel::sim
