#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/contact/interfaces.hpp"
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
  void makeKernels(bool fast);
  void uploadSteps();
  void copySaved(std::span<const Part> parts, bool saving) const;
  void allocate(int pairs);
  struct Tree {
    int levels = 0;
    gl::WordsArray leaves;
    gl::Vec4Array boxes;
  };
  void search(const ContactShared& shared) const;
  /// Boxes of both trees.
  void fit(const ContactShared& shared) const;
  void carry(const ContactShared& shared) const;
  [[nodiscard]] ContactShared shared(int index) const;
  [[nodiscard]] ContactNearList nearList() const;
  /// Calls `run` with each part, its range, and how many vertices it has.
  template <class Run>
  void forParts(std::span<const Part> parts, const Run& run) const;
  [[nodiscard]] std::span<const Part> cloths(std::span<const Part> parts) const;
  template <class Interface>
  void dispatchIndirect(const gl::Kernel<Interface>& kernel, int number, const Interface& given) const;

  ContactPlan plan_;
  int stepCount_;  ///< of a frame
  int maxPairs_ = 0;
  Tree faces_, edges_;
  gl::Vec4Array points_, nears_;
  gl::WordsArray candidates_, pairs_, corners_, tallies_;
  gl::Buffer control_;
  std::vector<gl::Buffer> saved_;  ///< of each part `now`, `velocities` and `trends`
  StepBlocks<shader::ContactStep> steps_;
  gl::Kernel<ContactRefit> refit_[3];  ///< of one, two, three levels at once
  gl::Kernel<ContactGather> gather_;
  gl::Kernel<ContactPlain<"contact/begin.comp">> begin_;
  gl::Kernel<ContactPlain<"contact/reach.comp">> reach_;
  gl::Kernel<ContactLeaves> leafBoxes_;
  gl::Kernel<ContactSearch> searchVertices_, searchEdges_;
  gl::Kernel<ContactLists> candidateLists_, pairLists_, nearList_;
  gl::Kernel<ContactSift> siftVertices_, siftEdges_;
  gl::Kernel<ContactNear> nearVertices_, nearEdges_;
  gl::Kernel<ContactNears<"contact/claim.comp">> claim_;
  gl::Kernel<ContactNears<"contact/push.comp">> push_;
  gl::Kernel<ContactNears<"contact/spread.comp">> spread_;
  gl::Kernel<ContactTallied> apply_;
  gl::Kernel<ContactStart> start_;
  gl::Kernel<ContactHand> hand_;
  gl::Kernel<ContactTake> take_;
  gl::Kernel<ContactHold> hold_;
  gl::Kernel<ContactLeave> leave_;
};

}  // namespace simreel::sim
