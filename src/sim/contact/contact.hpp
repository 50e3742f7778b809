#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/contact/interfaces.hpp"
#include "sim/contact/plan.hpp"
#include "sim/core/step_blocks.hpp"

#include <span>
#include <vector>

namespace simreel::sim {

/// Contact of cloths with themselves, with each other and with solids on the GPU (glsl/contact), computed
/// between the substeps of the cloths. Impulses keep faces and edges apart by the thickness of the cloths.
/// Where other forces are stronger, the path of a vertex is shortened, so that two features that do not
/// intersect at the start never pass through each other. Pinned vertices and solids follow their prescribed
/// motion, and the cloths yield. Impulses are summed as integers and the allowed fractions of paths are
/// combined by minima. The order in which pairs are found therefore does not affect the result, and its
/// bits are the same on every machine.
class Contact {
 public:
  /// Arrays of one simulation. Spans of Part have the order of the plan's parts. For a solid, only the
  /// positions are read and nothing is written, so the pointers to other arrays may be null.
  struct Part {
    const gl::Vec4Array* now;  ///< Positions at the substep's start: xyz in metres, w inverse mass in 1/kg.
    const gl::Vec4Array*
        next;  ///< Predicted positions at the substep's end; contact corrects them in place.
    const gl::Vec4Array* velocities;        ///< Velocities in m/s, updated to match `next`.
    const gl::Vec4Array* trends = nullptr;  ///< Additional state that restore() also resets; may be null.
  };

  Contact(ContactPlan plan, int substeps, bool fast);

  void beginFrame(std::span<const Part> parts);
  /// Waits for the GPU. Returns false if there was not enough memory for all near pairs; the memory is then
  /// enlarged, and the frame's substeps must be repeated after restore(). Throws UserError(device) if the
  /// GPU cannot provide that memory.
  bool endFrame();
  /// Resets `now`, `velocities` and `trends` to their contents at beginFrame().
  void restore(std::span<const Part> parts) const { copySaved(parts, false); }
  /// Applies contact impulses to `next`. Call it after the dispatches that predict `next`. `index` is the
  /// zero-based substep of the frame.
  void push(int index, std::span<const Part> parts);
  /// Shortens the paths of vertices that would pass through other features. Call it after push() and after
  /// the colliders have changed `next`.
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
  /// Recomputes the bounding boxes of both trees.
  void fit(const ContactShared& shared) const;
  void carry(const ContactShared& shared) const;
  [[nodiscard]] ContactShared shared(int index) const;
  [[nodiscard]] ContactNearList nearList() const;
  /// Calls `run` for each part with the part, its ContactRange, and its number of vertices.
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
  std::vector<gl::Buffer> saved_;  ///< Copies of `now`, `velocities` and `trends` of each part.
  StepBlocks<shader::ContactStep> steps_;
  gl::Kernel<ContactRefit> refit_[3];  ///< Kernels that recompute one, two and three levels of boxes per
                                       ///< dispatch.
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
  gl::Kernel<ContactReadBack> readBack_;
  gl::Kernel<ContactHold> hold_;
  gl::Kernel<ContactLeave> leave_;
};

}  // namespace simreel::sim
