#pragma once
#include "gl/condition.hpp"
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/fluid/array.hpp"
#include "sim/fluid/plan.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simreel::sim {

/// Solves for the pressure that makes a flow free of divergence: V-cycles of multigrid until what is
/// missing in the worst cell is small beside the greatest speed. All cycles there may be are dispatched,
/// indirectly; once that is reached the rest of them are empty, and the CPU waits for nothing.
class FluidPressure {
 public:
  /// What the kernels tell of their work.
  struct Report {
    float worstShare = 0, worstSpeed = 0, lastShare = 0, lastSpeed = 0;
    double cycles = 0;  ///< of a projection, on the average
  };

  /// `defines`: of all kernels of the fluid.
  FluidPressure(const std::string& name, const FluidPlan& plan, const gl::Defines& defines);

  /// Where obstacles are from now on.
  void setSolids(const FluidSolids& solids);
  /// Binds what kernels know of obstacles: faceAt, solidWord and solidSet of glsl/fluid/grid.glsl.
  void bindSolids() const;

  /// Of `flow`; the sum of corrections is left in the front of `pool`. `raised` is overwritten, too.
  void solve(const FluidArray& flow, const FluidArray& pool, const FluidArray& raised);
  /// Once the projected flow has been noted in control(): whether it is good enough, and not too fast.
  void judge(const gl::Buffer& status) const;

  /// After a state was loaded: what goes by the obstacles of now, and no speed, before fluid/fastest.comp
  /// finds it out anew.
  void resume();

  [[nodiscard]] const gl::Buffer& control() const { return control_; }
  [[nodiscard]] gl::Buffer& control() { return control_; }
  /// Waits for the GPU.
  [[nodiscard]] Report report() const;

 private:
  /// Kernels for tiles in the open and for the others.
  struct Pair {
    gl::Program open, others, both;
  };
  [[nodiscard]] Pair pairOf(const char* path, const gl::Defines& defines) const;
  /// Whether a level's tiles in the open and its others share a dispatch: on a graphics card, where those
  /// cost more than the work of small levels.
  [[nodiscard]] bool joins(std::size_t level) const;
  /// Sets coarse_ up, if there is such a kernel, and down_ and up_.
  void makeCoarse(const FluidPlan& plan, const gl::Defines& defines);
  void makeMiddle(const gl::Defines& defines);
  [[nodiscard]] int otherGroups(const FluidSolids& solids, std::size_t level) const;
  /// Three words for each dispatch that a cycle may have.
  [[nodiscard]] std::vector<std::uint32_t> groupsOf(const FluidSolids& solids) const;
  [[nodiscard]] std::vector<shader::FluidLevelPlace> places(const FluidSolids& solids) const;
  void indirect(const gl::Program& program, std::size_t number) const;
  void onLevel(const Pair& pair, std::size_t level) const;
  void cycle() const;

  const FluidLevels& levels_;  ///< but for their weights
  int cycles_;
  bool tileAGroup_;         ///< whether a group takes one of the tiles that are not in the open, not four
  gl::WordsArray weights_;  ///< FluidSolids::words
  gl::Buffer solids_, control_;
  StepBlocks<shader::FluidLevelPlace> places_;  ///< a level each
  Pair descend_, ascend_, residual_;
  gl::Program divergence_, bottom_, decide_, judge_;
  gl::Program coarse_;       ///< of storage blocks: levels from firstCoarse_ on
  std::size_t firstCoarse_;  ///< the coarsest, unless coarse_ takes more
  gl::Program down_, up_;    ///< several levels before firstCoarse_ at once
  std::size_t firstDown_, firstUp_;
  std::optional<gl::Condition> condition_;  ///< of cycles that are seldom wanted
  int tilesStart_;
  std::vector<std::uint32_t> groups_;
};

}  // namespace simreel::sim
