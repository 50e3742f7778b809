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
struct FloatDisplay;

/// Floating bodies on the GPU and the kernels that move them.
class FloatKernels {
 public:
  /// `plan` must outlive this object and must have at least one body.
  FloatKernels(const std::string& name, const WaterPlan& plan, bool fast);

  /// Computes the water that the bodies displace in the initial state. Later steps continue from it.
  void begin(const gl::Vec4Array& cells, const gl::Buffer& status) { step(-1, cells, status); }
  /// Uploads the bodies' parameters for the frame that starts at `time` (seconds).
  void startFrame(double time);
  /// Runs step `index` (from 0) of the frame: moves the bodies and applies their effect on the water. Call
  /// it after the water's step.
  void step(int index, const gl::Vec4Array& cells, const gl::Buffer& status);
  /// Computes the drawn vertices of the bodies.
  void prepareDrawing() const;
  void publish(Drawables& drawables) const;
  void visitCheckpointData(CarryOver& carry);
  void addState(std::vector<StateArray>& arrays) const;
  [[nodiscard]] const gl::Buffer& state() const { return bodies_[0].buffer(); }

 private:
  /// Drawing data of one body.
  struct Drawn {
    Drawn(const std::string& name, const Hull& hull);
    MeshTopology topology;
    gl::Vec4Array rest, restNormals, positions, normals;
    std::shared_ptr<const MovingMeshMaterials>
        looks;  ///< Material textures; bodies that use the same file have the same entry.
    int count;
    bool doubleSided = false;
  };

  const WaterPlan* plan_;
  std::vector<Drawn> drawn_;
  gl::Vec4Array bodies_[2];  ///< Current state, and the output of the next step.
  gl::Vec4Array points_, parameters_;
  /// Four integers per cell, in fixed-point units: increments of the depth and of the discharge along x and
  /// z, and the displaced depth.
  gl::Buffer sums_;
  StepBlocks<shader::FloatStep> steps_;
  gl::Kernel<FloatMove> move_;
  gl::Kernel<FloatPress> press_;
  gl::Kernel<FloatDisplay> display_;
};

}  // namespace simreel::sim
