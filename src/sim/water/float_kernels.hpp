#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/core/simulation.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/mesh/buffers.hpp"
#include "sim/mesh/looks.hpp"
#include "sim/water/plan.hpp"

#include <memory>
#include <string>
#include <vector>

namespace simreel::sim {

struct FloatMove;
struct FloatPress;
struct FloatShow;

/// Bodies that float, on the GPU.
class FloatKernels {
 public:
  /// `plan` outlives this; there is one body at least.
  FloatKernels(const std::string& name, const WaterPlan& plan, bool fast);

  /// What the first state's bodies displace, from which later steps go on.
  void begin(const gl::Vec4Array& cells, const gl::Buffer& status) { step(-1, cells, status); }
  /// What the frame that starts at `time` (s) is told.
  void startFrame(double time);
  /// Step `index` of the frame, from 0, after that of the water: moves bodies and water.
  void step(int index, const gl::Vec4Array& cells, const gl::Buffer& status);
  /// Makes what is drawn.
  void show() const;
  void publish(Drawables& drawables) const;
  void carryOver(CarryOver& carry);
  void addState(std::vector<StateArray>& arrays) const;
  [[nodiscard]] const gl::Buffer& state() const { return bodies_[0].buffer(); }

 private:
  /// What is drawn of a body.
  struct Drawn {
    Drawn(const std::string& name, const Hull& hull);
    MeshTopology topology;
    gl::Vec4Array rest, restNormals, positions, normals;
    std::shared_ptr<const MovingLooks> looks;  ///< bodies of one file share them
    int count;
    bool doubleSided = false;
  };

  const WaterPlan* plan_;
  std::vector<Drawn> drawn_;
  gl::Vec4Array bodies_[2];  ///< now, and where the next step writes
  gl::Vec4Array points_, told_;
  /// Four numbers a cell: units of depth and discharge that come, and the depth that is displaced.
  gl::Buffer sums_;
  StepBlocks<shader::FloatStep> steps_;
  gl::Kernel<FloatMove> move_;
  gl::Kernel<FloatPress> press_;
  gl::Kernel<FloatShow> show_;
};

}  // namespace simreel::sim
