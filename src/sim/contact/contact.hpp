#pragma once
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "sim/contact/plan.hpp"
#include "sim/core/step_blocks.hpp"

#include <span>
#include <vector>

namespace simreel::sim {

/// Contact of cloths with themselves and each other on the GPU (glsl/contact), between the substep that
/// each makes by itself and the next. Faces and edges keep the thickness between them; where forces are too
/// strong for that, they are held back, so that none ever passes through another that it was apart from at
/// the start. What is held by pins goes where the pins take it.
///
/// Impulses are summed up as integers and ways are shortened by minima, so the order in which pairs are
/// found does not matter, and the bits are the same everywhere.
class Contact {
 public:
  /// A simulation's own arrays, in the order of the parts of the plan.
  struct Part {
    const gl::Vec4Array* now;         ///< at the substep's start: xyz m, w inverse mass in 1/kg
    const gl::Vec4Array* next;        ///< where it would lead; becomes where it leads
    const gl::Vec4Array* velocities;  ///< xyz m/s, made to agree
  };

  Contact(ContactPlan plan, int substeps, bool fast);

  /// Looks at how much the last frame found, and gets more memory where that came near what there is.
  /// Throws UserError(device) where it was not enough: states since then are lost.
  void beginFrame();
  /// Behind the dispatches that made `next`: changes it by the contacts' impulses. `index` of the frame's
  /// substeps.
  void push(int index, std::span<const Part> parts);
  /// After push(), where colliders may have moved `next` again: holds back what would pass through.
  void hold(int index, std::span<const Part> parts);

 private:
  void makePrograms(bool fast);
  void allocate(int pairs);
  void search() const;
  void bind(int index) const;
  template <class Bind>
  void forParts(const gl::Program& program, std::span<const Part> parts, const Bind& bind) const;
  void dispatchIndirect(const gl::Program& program, int number) const;

  ContactPlan plan_;
  int stepCount_;  ///< of a frame
  int maxPairs_ = 0;
  gl::Vec4Array points_, boxes_, nears_;
  gl::WordsArray leaves_, pairs_, corners_;
  gl::Buffer tallies_, control_;
  StepBlocks<shader::ContactStep> steps_;
  gl::Program gather_, begin_, reach_, leafBoxes_, refit_, search_, pairLists_, nearVertices_, nearEdges_,
      nearList_, claim_, push_, apply_, hand_, take_, hold_, leave_;
};

}  // namespace simreel::sim
