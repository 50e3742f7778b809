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
struct GarmentDisplay;

/// Owns the GPU state of a cloth made of triangles and dispatches the kernels of a substep in this order:
/// air forces per face, forces and prediction per vertex, stretch and shear of the faces one colour at a
/// time, and finally velocities and collisions.
class GarmentKernels {
 public:
  /// Uniform block of one substep (shader::ClothStep).
  using Step = gl::Resource;

  /// Keeps a pointer to `plan`, which must outlive this object.
  GarmentKernels(const std::string& name, const GarmentPlan& plan, const TouchVariant& touch, bool fast);

  /// Prepares the frame from time `begin` to `end` (seconds).
  void beginFrame(double begin, double end) { hold_.beginFrame(plan_->skinPins(), begin, end); }
  /// Computes the state after a substep, where `bending` is an index into the plan's bendings. finish()
  /// makes it the current state.
  void predict(int substep, const Step& step, std::size_t bending, const TouchPart& touch);
  /// Recomputes velocities and collisions (the last part of predict()) for the vertices that contact has
  /// moved since then.
  void settle(const Step& step, const TouchPart& touch) const { meet(settleAgain_, step, touch); }
  void finish() { std::swap(positions_[0], positions_[1]); }
  /// Computes the drawn positions and normals of the current state; `step` can be the block of any substep.
  void prepareDrawing(const Step& step) const;

  [[nodiscard]] gl::Vec4Array& positions() { return positions_[0]; }
  [[nodiscard]] const gl::Vec4Array& positions() const { return positions_[0]; }
  [[nodiscard]] gl::Vec4Array& nextPositions() { return positions_[1]; }
  [[nodiscard]] const gl::Vec4Array& nextPositions() const { return positions_[1]; }
  [[nodiscard]] gl::Vec4Array& velocities() { return velocities_; }
  [[nodiscard]] const gl::Vec4Array& velocities() const { return velocities_; }
  /// Returns the trends of the constraints (glsl/cloth/motion.glsl). For a pinned vertex the element is the
  /// rest position instead.
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
  int vertices_;                ///< number of vertices, including the ghost points of clamped edges
  gl::Vec4Array positions_[2];  ///< current positions, and the output of the next substep
  gl::Vec4Array velocities_, trends_, elements_, faceForces_;
  gl::Vec4Array left_;  ///< for a cloth in contact: the predicted positions before contact pushed the
                        ///< vertices
  gl::WordsArray corners_, rings_, copies_, stitches_, attachments_;
  std::vector<gl::WordsArray> fans_, entries_;  ///< one array for each entry of the plan's bendings
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
  gl::Kernel<GarmentDisplay> display_;
};

}  // namespace simreel::sim
