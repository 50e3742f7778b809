#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/cloth/plan.hpp"
#include "sim/cloth/skin_hold.hpp"
#include "sim/cloth/thin.hpp"
#include "sim/touch/touch.hpp"

#include <string>

namespace simreel::sim {

/// What glsl/cloth/kernel.glsl is given in a substep, a part of the kernels' interfaces.
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

/// A sheet of particles on the GPU: its state and the dispatches of a substep.
class ClothKernels {
 public:
  /// `plan` outlives this.
  ClothKernels(const std::string& name, const ClothPlan& plan, const TouchVariant& touch, bool fast);

  /// For the frame from `begin` to `end` (s).
  void beginFrame(double begin, double end) { hold_.beginFrame(plan_->skinPins(), begin, end); }
  /// Where a substep leads; finish() takes it as the state.
  void predict(int substep, const ClothPart& part);
  /// The same again of particles that contact has pushed since.
  void settle(const ClothPart& part) const;
  void finish();

  [[nodiscard]] gl::Vec4Array& positions() { return positions_[0]; }
  [[nodiscard]] const gl::Vec4Array& positions() const { return positions_[0]; }
  [[nodiscard]] const gl::Vec4Array& nextPositions() const { return positions_[1]; }
  /// As far as the substep has come.
  [[nodiscard]] gl::Vec4Array& velocities() { return velocities_[hasTrends() && predicted_ ? 1 : 0]; }
  [[nodiscard]] const gl::Vec4Array& velocities() const {
    return velocities_[hasTrends() && predicted_ ? 1 : 0];
  }
  /// Of constraints (glsl/cloth/motion.glsl).
  [[nodiscard]] gl::Vec4Array& trends() { return trends_; }
  [[nodiscard]] const gl::Vec4Array& trends() const { return trends_; }
  /// True where constraints have a trend: those that keep energy are forces.
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
  void fendThin(const ClothPart& part) const;
  [[nodiscard]] int lineCount(glm::ivec2 reach) const;
  [[nodiscard]] bool bends() const { return relaxedFamilies(plan_->parameters()).size() > 2; }

  const ClothPlan* plan_;
  glm::ivec2 size_;
  bool constrained_;  ///< by XPBD; else springs
  bool keeps_;        ///< energy (glsl/cloth/keeping.glsl)
  /// An invocation takes a line of pairs (constrain_lines.comp) instead of one, and the first also steps.
  bool inLines_ = gl::memoryPath() == gl::MemoryPath::texel;
  bool predicted_ = false;      ///< between predict() and finish()
  gl::Vec4Array positions_[2];  ///< now, and where the next substep writes
  gl::Vec4Array between_;       ///< positions after the diagonal constraints, where those of bending follow
  gl::Vec4Array velocities_[2];  ///< now, and of constraints where the next substep writes
  gl::Vec4Array trends_;
  gl::Vec4Array left_;  ///< of cloth in contact: where it was left before contact pushed
  SkinHold hold_;
  ThinColliders thin_;
  gl::Kernel<ClothStepKernel> step_;
  gl::Kernel<ClothRelaxKernel> relax_[2];  ///< diagonal pairs, those of bending
  gl::Kernel<ClothLinesKernel> lines_[2];  ///< the first family, others
  gl::Kernel<ClothSolveKernel> rows_, columns_;
  gl::Kernel<ClothSettleKernel> settle_;
  gl::Kernel<ClothThinKernel> findThin_;
};

}  // namespace simreel::sim
