#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/contact/interfaces.hpp"
#include "sim/contact/plan.hpp"
#include "sim/core/step_blocks.hpp"

#include <span>
#include <vector>

namespace simreel::sim {

/// Contact of cloths with themselves, each other, and solids on the GPU (glsl/contact), between the cloths'
/// own substeps. Impulses keep faces and edges apart by the cloths' thickness; where forces are too strong
/// for that, motion is shortened, so that features that are apart at the start never pass through each
/// other. Pinned vertices and solids follow their own motion, and cloths give way. Impulses are integer
/// sums and motions are shortened by minima, so the order in which pairs are found does not affect the
/// result and its bits are the same on every machine.
class Contact {
 public:
  /// Arrays of one simulation, in the order of the plan's parts. For a solid only the positions are read
  /// and nothing is written; its other pointers may be null.
  struct Part {
    const gl::Vec4Array* now;  ///< Positions at the substep's start: xyz in metres, w inverse mass in 1/kg.
    const gl::Vec4Array*
        next;  ///< Predicted positions at the substep's end; contact corrects them in place.
    const gl::Vec4Array* velocities;  ///< Velocities in m/s, updated to match `next`.
    const gl::Vec4Array* trends =
        nullptr;  ///< Additional state that restore() resets as well; may be null.
  };

  Contact(ContactPlan plan, int substeps, bool fast);

  void beginFrame(std::span<const Part> parts);
  /// Waits for the device. Returns false if there were more near pairs than memory for them; the memory is
  /// then enlarged, and the frame's substeps must be repeated after restore(). Throws UserError(device) if
  /// the device cannot provide that memory.
  bool endFrame();
  /// Resets `now`, `velocities` and `trends` to their contents at beginFrame().
  void restore(std::span<const Part> parts) const { copySaved(parts, false); }
  /// Applies contact impulses to `next`; call after the dispatches that predicted `next`. `index`:
  /// zero-based substep of the frame.
  void push(int index, std::span<const Part> parts);
  /// Shortens motions that would pass through other features; call after push() and after colliders moved
  /// `next` again.
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
  /// Refits the bounding boxes of both trees.
  void fit(const ContactShared& shared) const;
  void carry(const ContactShared& shared) const;
  [[nodiscard]] ContactShared shared(int index) const;
  [[nodiscard]] ContactNearList nearList() const;
  /// Calls `run` with each part, its range, and its number of vertices.
  template <class Run>
  void forParts(std::span<const Part> parts, const Run& run) const;
  [[nodiscard]] std::span<const Part> cloths(std::span<const Part> parts) const;
  template <class Interface>
  void dispatchIndirect(const gl::Kernel<Interface>& kernel, int number, const Interface& given) const;

  ContactPlan plan_;
  int stepCount_;  ///< Number of substeps per frame.
  int maxPairs_ = 0;
  Tree faces_, edges_;
  gl::Vec4Array points_, nears_;
  gl::WordsArray candidates_, pairs_, corners_, tallies_;
  gl::Buffer control_;
  std::vector<gl::Buffer> saved_;  ///< For each part: `now`, `velocities` and `trends`.
  StepBlocks<shader::ContactStep> steps_;
  gl::Kernel<ContactRefit> refit_[3];  ///< Kernels that refit one, two and three levels at once.
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
