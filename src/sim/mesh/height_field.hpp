#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/carry_over.hpp"
#include "sim/core/port.hpp"
#include "sim/mesh/height_plan.hpp"

#include <string>

namespace simreel::sim {

struct HeightsKernel;

/// Part of a kernel interface: inputs of glsl/mesh/height_array.glsl if HEIGHTS is 1.
struct HeightPart {
  gl::Uniform<"heightGrid.corner", glm::vec2> corner;
  gl::Uniform<"heightGrid.perCell", glm::vec2> perCell;
  gl::Uniform<"heightGrid.size", glm::ivec2> size;
  gl::Uniform<"heightGrid.progress", float> progress;
  gl::Uniform<"heightGrid.perFrame", float> perFrame;
  gl::Uniform<"heightGrid.kept", float> kept;
  gl::Uniform<"heightGrid.bounce", float> bounce;
  gl::Uniform<"heightGrid.margin", float> margin;
  gl::In<"heights"> heights;
};

/// Heights of a deformed plane on the GPU at the beginning and the end of a frame, for objects that fall
/// onto it (glsl/mesh/height_model.glsl).
class HeightField {
 public:
  static const PortInfo port;

  HeightField(const std::string& name, const HeightPlan& plan);

  /// Stores new heights for the end of the frame; the previous end becomes the beginning of the frame. The
  /// first call sets the heights at the start of the run. `positions` are in the mesh's local space;
  /// `component` is the index of the component with the height (1 or 0).
  void setHeights(const gl::Vec4Array& positions, int component = 1);
  void visitCheckpointData(CarryOver& carry) { carry.array("heights", heights_.buffer()); }
  /// Returns the heights and the time within the frame as kernel inputs. The arguments are the same as for
  /// HeightPlan::at().
  [[nodiscard]] HeightPart part(int substep, int substeps, float margin, float bounce) const;

 private:
  HeightPlan plan_;
  gl::Vec4Array heights_;  ///< x: height at the beginning of the frame, y: height at its end, in metres
  gl::Kernel<HeightsKernel> keep_;
};

}  // namespace simreel::sim
