#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/core/drawable.hpp"
#include "sim/reaction/plan.hpp"
#include "sim/reaction/text/kernel_text.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace simreel::sim {

struct RuleKernel;
struct StripKernel;
struct LostKernel;
struct ReactionPaint;
struct BrushKernel;
struct SampleKernel;

/// Owns the planes of a rule on the GPU and the kernels that step them.
class ReactionKernels {
 public:
  /// Returns the fastest settings for this device's memory path (tools/bench/README.md).
  [[nodiscard]] static WorkSplit bestCut();
  /// Throws UserError(device) if the grid exceeds a limit of the device.
  ReactionKernels(const std::string& name, const ReactionPlan& plan, bool fast,
                  const WorkSplit& cut = bestCut());

  /// Sets the uniform values for the following steps (see ReactionPlan::valuesAt).
  void setValues(const std::vector<float>& values);
  /// Runs `steps` steps, starting with step `number`. `first` is the step number of the initial state, at
  /// which the model's time is 0.
  void advance(long number, int steps, long first);
  /// Samples a field as the map of a parameter. If `layers` is more than 1, the field is a volume with that
  /// many layers. Throws UserError(usage) if a side of the field (of one layer) is longer than
  /// maxSampledSide cells.
  void setMap(int parameter, const Field& field, int layers = 1);
  /// Returns the parameters' maps; the array is empty if no parameter has a map.
  [[nodiscard]] gl::Vec4Array& maps() { return weights_; }
  void paint(const ReactionPlan::Painted& painted);
  /// Computes the displayed value of the state at step `number`, unless the displayed value is a species.
  void prepareDrawing(long number, long first);

  [[nodiscard]] const gl::Buffer& status() const { return status_; }
  /// Returns the planes of the species.
  [[nodiscard]] const gl::Vec4Array& cells() const { return cells_[0]; }
  [[nodiscard]] gl::Vec4Array& cells() { return cells_[0]; }
  /// Returns a view of the species' planes as 32-bit words, for Field.
  [[nodiscard]] const gl::Texture& words() const { return words_[0]; }
  /// Returns the view, as 32-bit words, that contains a displayed or tinting plane.
  [[nodiscard]] const gl::Texture& wordsOf(const RulePlane& shown) const {
    return shown.array == RuleArray::stage ? words_[0] : letWords_;
  }
  [[nodiscard]] int columns() const { return columns_; }

 private:
  struct Pass {
    gl::Kernel<RuleKernel> kernel;
    gl::Buffer uniforms;
    std::vector<float> written;
  };
  [[nodiscard]] Pass& firstPass();
  void makeInputs(const std::string& name, const gl::Defines& defines);
  void paintInSpace(const ReactionPlan::Painted& painted);
  void step(long number, long first);
  /// Runs several steps per dispatch, in strips.
  void strips(long number, long lostFirst);
  const gl::Kernel<SampleKernel>& samplerOf(Field::Cells cells, bool layers);
  void makeStrips();
  void tellLost(long first, int steps);
  void run(int pass, const gl::Vec4Array& stage, const gl::Vec4Array& next, long number);
  void tell(int pass);
  [[nodiscard]] std::vector<glm::vec4> packed(const RulePlanes& planes) const;

  const ReactionPlan& plan_;
  glm::ivec2 size_;
  int depth_, layerItems_;
  int columns_;
  WorkSplit cut_;
  std::string name_;
  bool mayStrip_ = false;
  gl::Defines stripDefines_;
  double cellSteps_ = 0;    ///< Number of cell updates computed so far: cells times steps.
  gl::Vec4Array cells_[2];  ///< Current state, and the output of the next step.
  gl::Texture words_[2];
  gl::Vec4Array stages_[2];  ///< Intermediate states between the stages of a step.
  gl::Vec4Array sums_, lets_, weights_;
  gl::Texture letWords_;
  gl::WordsArray stamps_, links_, places_;
  gl::Buffer status_;
  gl::Kernel<ReactionPaint> paint_;
  gl::Kernel<BrushKernel> brush_;  ///< Brush kernel for volumes and meshes.
  std::map<std::pair<Field::Cells, bool>, gl::Kernel<SampleKernel>>
      samplers_;  ///< Kernels that sample other objects' fields, by cell format and by whether the field is
                  ///< a volume.
  std::vector<Pass> passes_;
  gl::Kernel<StripKernel> strips_;
  gl::Kernel<LostKernel> lost_;
  gl::Buffer lostCells_;  ///< For each of up to lostSteps steps, the minimum index of the lost cells.
  std::vector<float> values_;
};

}  // namespace simreel::sim
