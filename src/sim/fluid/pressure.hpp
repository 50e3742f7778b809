#pragma once
#include "gl/condition.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/fluid/array.hpp"
#include "sim/fluid/part.hpp"
#include "sim/fluid/plan.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simreel::sim {

struct FluidLevelPart;
struct FluidDescend;
struct FluidAscend;
struct FluidResidual;
struct FluidDivergence;
struct FluidBottom;
struct FluidDecide;
struct FluidCoarse;
struct FluidDown;
struct FluidUp;

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
  /// What a step is told and what kernels know of obstacles.
  [[nodiscard]] FluidPart part(const gl::Resource& step) const;

  /// Of `flow`; the sum of corrections is left in the front of `pool`. `raised` is overwritten, too.
  void solve(const FluidPart& part, const FluidArray& flow, const FluidArray& pool,
             const FluidArray& raised, const gl::Buffer& status) const;
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
  template <class Interface>
  struct Pair {
    gl::Kernel<Interface> open, others, both;
  };
  /// What the kernels of a solve share.
  struct Memory {
    gl::Resource pool, raised;
    const gl::Buffer* status;
  };
  template <class Interface>
  void makePair(Pair<Interface>& pair, const gl::Defines& defines) const;
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
  template <class Interface>
  void indirect(const gl::Kernel<Interface>& kernel, std::size_t number, const Interface& given) const;
  template <class Interface>
  void onLevel(const Pair<Interface>& pair, std::size_t level, const Interface& given) const;
  [[nodiscard]] FluidLevelPart levelPart(std::size_t level, const Memory& memory) const;
  [[nodiscard]] FluidDecide decision(const gl::Buffer& status, bool first, float tolerance) const;
  /// Cells and places of `count` levels from `first` on, then zeros.
  [[nodiscard]] std::vector<glm::ivec4> placesFrom(std::size_t first, std::size_t count,
                                                   std::size_t elements) const;
  void bottom(const Memory& memory) const;
  void cycle(const Memory& memory) const;

  const FluidLevels& levels_;  ///< but for their weights
  int cycles_;
  bool tileAGroup_;         ///< whether a group takes one of the tiles that are not in the open, not four
  gl::WordsArray weights_;  ///< FluidSolids::words
  gl::Buffer solids_, control_;
  StepBlocks<shader::FluidLevelPlace> places_;  ///< a level each
  Pair<FluidDescend> descend_;
  Pair<FluidAscend> ascend_;
  Pair<FluidResidual> residual_;
  gl::Kernel<FluidDivergence> divergence_;
  gl::Kernel<FluidBottom> bottom_;
  gl::Kernel<FluidDecide> decide_, judge_;
  gl::Kernel<FluidCoarse> coarse_;  ///< of storage blocks: levels from firstCoarse_ on
  std::size_t firstCoarse_;         ///< the coarsest, unless coarse_ takes more
  gl::Kernel<FluidDown> down_;      ///< several levels before firstCoarse_ at once
  gl::Kernel<FluidUp> up_;
  std::vector<glm::ivec4> coarseLevels_, downLevels_, upLevels_;
  float mostSpeed_;
  std::size_t firstDown_, firstUp_;
  std::optional<gl::Condition> condition_;  ///< of cycles that are seldom wanted
  int tilesStart_;
  std::vector<std::uint32_t> groups_;
};

}  // namespace simreel::sim
