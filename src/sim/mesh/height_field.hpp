#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/program.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/core/port.hpp"
#include "sim/mesh/height_plan.hpp"

#include <string>

namespace simreel::sim {

struct HeightsKernel;

/// Heights of a deformed plane on the GPU, at the beginning and at the end of a frame, for those that fall
/// onto it (glsl/mesh/height_model.glsl).
class HeightField {
 public:
  static const PortInfo port;

  HeightField(const std::string& name, const HeightPlan& plan);

  /// The next frame's end: `positions` in the mesh's own space. Before a first frame, its beginning.
  /// `component` of them that is the height: 1, or 0.
  void take(const gl::Vec4Array& positions, int component = 1);
  void carryOver(CarryOver& carry) { carry.array("heights", heights_.buffer()); }
  /// For height_array.glsl of a kernel.
  void bind() const { heights_.bindInput(shader::heightsBinding); }
  /// Tells a kernel where in the frame it is; arguments as of HeightPlan::at.
  void tell(const gl::Program& kernel, int substep, int substeps, float margin, float bounce) const;

 private:
  HeightPlan plan_;
  gl::Vec4Array heights_;  ///< x before, y now (m)
  gl::Kernel<HeightsKernel> keep_;
};

}  // namespace simreel::sim
