#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/cloth/skin_hold.hpp"
#include "sim/cloth/thin.hpp"
#include "sim/garment/plan.hpp"
#include "sim/touch/touch.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

struct GarmentRings;
struct GarmentAir;
struct GarmentPredict;
struct GarmentStretch;
struct GarmentAttach;
struct GarmentSew;
struct GarmentSettle;
struct GarmentThin;
struct GarmentShow;

/// Cloth of triangles on the GPU: its state and the dispatches of a substep. What the air does to faces;
/// forces and a prediction by vertices; stretch and shear, a colour of faces after the other; then speeds
/// and what the cloth meets.
class GarmentKernels {
 public:
  /// What a substep is told: a block of shader::ClothStep.
  using Step = gl::Resource;

  /// `plan` outlives this.
  GarmentKernels(const std::string& name, const GarmentPlan& plan, const TouchVariant& touch, bool fast);

  /// For the frame from `begin` to `end` (s).
  void beginFrame(double begin, double end) { hold_.beginFrame(plan_->skinPins(), begin, end); }
  /// Where a substep leads, with a bending of the plan; finish() takes it as the state.
  void predict(int substep, const Step& step, std::size_t bending, const TouchPart& touch);
  /// The last part of it again, of vertices that contact has pushed since.
  void settle(const Step& step, const TouchPart& touch) const { meet(settleAgain_, step, touch); }
  void finish() { std::swap(positions_[0], positions_[1]); }
  /// Makes what is drawn of the present state; `step` is any.
  void show(const Step& step) const;

  [[nodiscard]] gl::Vec4Array& positions() { return positions_[0]; }
  [[nodiscard]] const gl::Vec4Array& positions() const { return positions_[0]; }
  [[nodiscard]] const gl::Vec4Array& nextPositions() const { return positions_[1]; }
  [[nodiscard]] gl::Vec4Array& velocities() { return velocities_; }
  [[nodiscard]] const gl::Vec4Array& velocities() const { return velocities_; }
  /// glsl/cloth/motion.glsl; of what is pinned where it is at rest.
  [[nodiscard]] gl::Vec4Array& trends() { return trends_; }
  [[nodiscard]] const gl::Vec4Array& trends() const { return trends_; }
  [[nodiscard]] const gl::Vec4Array& drawnPositions() const { return drawnPositions_; }
  [[nodiscard]] const gl::Vec4Array& drawnNormals() const { return drawnNormals_; }
  [[nodiscard]] const gl::Buffer& status() const { return status_; }

 private:
  void makeArrays(const std::string& name);
  void makeKernels(const TouchVariant& touch, bool fast);
  [[nodiscard]] GarmentRings around(std::size_t bending) const;
  void push(const Step& step, const FluidWindPart& wind) const;
  void accelerate(const Step& step, std::size_t bending) const;
  void stretch(const Step& step) const;
  void attach(const Step& step) const;
  void sew(const Step& step) const;
  void meet(const gl::Kernel<GarmentSettle>& settling, const Step& step, const TouchPart& touch) const;

  const GarmentPlan* plan_;
  int vertices_;                ///< with the ghosts of clamped edges
  gl::Vec4Array positions_[2];  ///< now, and where the next substep writes
  gl::Vec4Array velocities_, trends_, elements_, faceForces_;
  gl::Vec4Array left_;  ///< of cloth in contact: where it was left before contact pushed
  gl::WordsArray corners_, rings_, copies_, stitches_, attachments_;
  std::vector<gl::WordsArray> fans_, entries_;  ///< of each bending
  gl::Vec4Array drawnPositions_, drawnNormals_;
  gl::Buffer status_;
  SkinHold hold_;
  ThinColliders thin_;
  gl::Kernel<GarmentAir> air_;
  gl::Kernel<GarmentPredict> predict_;
  gl::Kernel<GarmentStretch> stretch_;
  gl::Kernel<GarmentAttach> attach_;
  gl::Kernel<GarmentSew> sew_;
  gl::Kernel<GarmentSettle> settle_, settleAgain_;
  gl::Kernel<GarmentThin> findThin_;
  gl::Kernel<GarmentShow> show_;
};

}  // namespace simreel::sim
