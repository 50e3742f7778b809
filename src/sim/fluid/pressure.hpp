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

/// Solves for the pressure that makes a flow divergence-free, by multigrid V-cycles, until the maximum
/// residual of all cells is small relative to the maximum speed. The maximum number of cycles is always
/// dispatched, indirectly; after convergence the remaining dispatches are empty, so the CPU never waits.
class FluidPressure {
 public:
  /// Statistics from the solver kernels for the worst and the last projection: ratio of divergence to
  /// speed, and speed.
  struct Report {
    float worstShare = 0, worstSpeed = 0, lastShare = 0, lastSpeed = 0;
    double cycles = 0;  ///< Mean number of cycles per projection.
  };

  /// `defines` are the preprocessor definitions common to all kernels of the fluid.
  FluidPressure(const std::string& name, const FluidPlan& plan, const gl::Defines& defines);

  /// Uploads the current obstacles.
  void setSolids(const FluidSolids& solids);
  /// Returns the interface part common to all kernels, with the step's uniform block (`step`) and the
  /// obstacles.
  [[nodiscard]] FluidPart part(const gl::Resource& step) const;

  /// Solves for the pressure of `flow` and leaves the sum of all corrections at the start of `pool`.
  /// Overwrites `raised`.
  void solve(const FluidPart& part, const FluidArray& flow, const FluidArray& pool,
             const FluidArray& raised, const gl::Buffer& status) const;
  /// Checks whether the divergence of the projected flow is small enough and its speed is not too high, and
  /// writes `status`. The flow must already be recorded in control().
  void judge(const gl::Buffer& status) const;

  /// Call it after loading a state. Uploads the dispatch sizes of the current obstacles and clears the
  /// speed, which fluid/fastest.comp then recomputes.
  void resume();

  [[nodiscard]] const gl::Buffer& control() const { return control_; }
  [[nodiscard]] gl::Buffer& control() { return control_; }
  /// Reads back the statistics; waits for the GPU.
  [[nodiscard]] Report report() const;

 private:
  /// Three variants of a kernel: for open tiles, for the other tiles, and for both in one dispatch.
  template <class Interface>
  struct Pair {
    gl::Kernel<Interface> open, others, both;
  };
  /// Memory used by all kernels of one solve.
  struct Memory {
    gl::Resource pool, raised;
    const gl::Buffer* status;
  };
  template <class Interface>
  void makePair(Pair<Interface>& pair, const gl::Defines& defines) const;
  /// Returns true if one dispatch processes both the open and the other tiles of a level. That is so on the
  /// storage path for small levels, where an additional dispatch costs more than the work.
  [[nodiscard]] bool joins(std::size_t level) const;
  /// makeCoarse() sets up coarse_ if a level is small enough for it. makeMiddle() sets up down_ and up_.
  void makeCoarse(const FluidPlan& plan, const gl::Defines& defines);
  void makeMiddle(const gl::Defines& defines);
  [[nodiscard]] int otherGroups(const FluidSolids& solids, std::size_t level) const;
  /// Returns the indirect dispatch sizes: three words for each dispatch of a cycle.
  [[nodiscard]] std::vector<std::uint32_t> groupsOf(const FluidSolids& solids) const;
  [[nodiscard]] std::vector<shader::FluidLevelPlace> places(const FluidSolids& solids) const;
  template <class Interface>
  void indirect(const gl::Kernel<Interface>& kernel, std::size_t number, const Interface& given) const;
  template <class Interface>
  void onLevel(const Pair<Interface>& pair, std::size_t level, const Interface& given) const;
  [[nodiscard]] FluidLevelPart levelPart(std::size_t level, const Memory& memory) const;
  [[nodiscard]] FluidDecide decision(const gl::Buffer& status, bool first, float tolerance) const;
  /// Returns the cell counts and start indices of `count` levels from `first` on, padded with zeros to
  /// `elements` entries.
  [[nodiscard]] std::vector<glm::ivec4> placesFrom(std::size_t first, std::size_t count,
                                                   std::size_t elements) const;
  void bottom(const Memory& memory) const;
  void cycle(const Memory& memory) const;

  const FluidLevels& levels_;  ///< Used only for the grid sizes, not for the weights.
  int cycles_;
  bool tileAGroup_;         ///< True if a workgroup processes a single tile of the tiles that are not open,
                            ///< false if it processes four tiles.
  gl::WordsArray weights_;  ///< Face weights of all levels, and obstacle data (FluidSolids::words).
  gl::Buffer solids_, control_;
  StepBlocks<shader::FluidLevelPlace> places_;  ///< Uniform blocks, one per multigrid level.
  Pair<FluidDescend> descend_;
  Pair<FluidAscend> ascend_;
  Pair<FluidResidual> residual_;
  gl::Kernel<FluidDivergence> divergence_;
  gl::Kernel<FluidBottom> bottom_;
  gl::Kernel<FluidDecide> decide_, judge_;
  gl::Kernel<FluidCoarse> coarse_;  ///< Kernel that solves all levels from firstCoarse_ on. It exists only
                                    ///< on the storage path.
  std::size_t firstCoarse_;         ///< Index of the coarsest level, or of the first level that coarse_
                                    ///< processes.
  gl::Kernel<FluidDown> down_;      ///< Kernel that processes several levels before firstCoarse_ in one
                                    ///< dispatch.
  gl::Kernel<FluidUp> up_;
  std::vector<glm::ivec4> coarseLevels_, downLevels_, upLevels_;
  float maxSpeed_;
  std::size_t firstDown_, firstUp_;
  std::optional<gl::Condition> condition_;  ///< Condition that skips the cycles that are rarely needed.
  int tilesStart_;
  std::vector<std::uint32_t> groups_;
};

}  // namespace simreel::sim
