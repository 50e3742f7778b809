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
/// the start. What is held by pins goes where the pins take it, and solids where they go: cloths give way.
///
/// Impulses are summed up as integers and ways are shortened by minima, so the order in which pairs are
/// found does not matter, and the bits are the same everywhere.
class Contact {
 public:
  /// A simulation's own arrays, in the order of the parts of the plan. Of a solid only its positions count,
  /// and nothing is written: the rest may be null.
  struct Part {
    const gl::Vec4Array* now;               ///< at the substep's start: xyz m, w inverse mass in 1/kg
    const gl::Vec4Array* next;              ///< where it would lead; becomes where it leads
    const gl::Vec4Array* velocities;        ///< xyz m/s, made to agree
    const gl::Vec4Array* trends = nullptr;  ///< goes back with them in restore(); null: none
  };

  Contact(ContactPlan plan, int substeps, bool fast);

  void beginFrame(std::span<const Part> parts);
  /// Waits for the device. False: more came near each other than there was memory for, which there is now;
  /// after restore() the frame's substeps are to be done again. Throws UserError(device) where the device
  /// has no such memory.
  bool endFrame();
  /// Puts `now`, `velocities` and `trends` back as they were at beginFrame().
  void restore(std::span<const Part> parts) const { copySaved(parts, false); }
  /// Behind the dispatches that made `next`: changes it by the contacts' impulses. `index` of the frame's
  /// substeps.
  void push(int index, std::span<const Part> parts);
  /// After push(), where colliders may have moved `next` again: holds back what would pass through.
  void hold(int index, std::span<const Part> parts);

 private:
  void makePrograms(bool fast);
  void uploadSteps();
  void copySaved(std::span<const Part> parts, bool saving) const;
  void allocate(int pairs);
  struct Tree {
    int levels = 0;
    gl::WordsArray leaves;
    gl::Vec4Array boxes;
  };
  void search() const;
  /// Boxes of both trees.
  void fit() const;
  void carry() const;
  void bind(int index) const;
  template <class Bind>
  void forParts(const gl::Program& program, std::span<const Part> parts, const Bind& bind) const;
  [[nodiscard]] std::span<const Part> cloths(std::span<const Part> parts) const;
  void dispatchIndirect(const gl::Program& program, int number) const;

  ContactPlan plan_;
  int stepCount_;  ///< of a frame
  int maxPairs_ = 0;
  Tree faces_, edges_;
  gl::Vec4Array points_, nears_;
  gl::WordsArray candidates_, pairs_, corners_, tallies_;
  gl::Buffer control_;
  std::vector<gl::Buffer> saved_;  ///< of each part `now`, `velocities` and `trends`
  StepBlocks<shader::ContactStep> steps_;
  gl::Program refit_[3];  ///< of one, two, three levels at once
  gl::Program gather_, begin_, reach_, leafBoxes_, searchVertices_, searchEdges_, candidateLists_,
      siftVertices_, siftEdges_, pairLists_, nearVertices_, nearEdges_, nearList_, claim_, push_, apply_,
      hand_, take_, hold_, leave_, start_, spread_;
};

}  // namespace simreel::sim
