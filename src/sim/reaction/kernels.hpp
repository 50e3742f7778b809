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

/// The planes of a rule on the GPU and the kernels that step them.
class ReactionKernels {
 public:
  /// What is fastest on this device's memory path (tools/bench/README.md).
  [[nodiscard]] static RuleCut bestCut();
  /// Throws UserError(device) when the grid is beyond a limit of the device.
  ReactionKernels(const std::string& name, const ReactionPlan& plan, bool fast,
                  const RuleCut& cut = bestCut());

  /// What the following steps use, from ReactionPlan::valuesAt.
  void setValues(const std::vector<float>& values);
  /// Steps from that number on; `first`: that of the first state, where the model's time is 0.
  void advance(long number, int steps, long first);
  /// Takes a field as the map of a parameter; one of more than one layer is a volume's. Throws
  /// UserError(usage) where it is too wide.
  void take(int parameter, const Field& field, int layers = 1);
  /// Maps of parameters; empty without any.
  [[nodiscard]] gl::Vec4Array& maps() { return weights_; }
  void paint(const ReactionPlan::Painted& painted);
  /// Computes what is shown of the state at a step, where that is no species.
  void show(long number, long first);

  [[nodiscard]] const gl::Buffer& status() const { return status_; }
  /// Planes of species.
  [[nodiscard]] const gl::Vec4Array& cells() const { return cells_[0]; }
  [[nodiscard]] gl::Vec4Array& cells() { return cells_[0]; }
  /// The same as words, for Field.
  [[nodiscard]] const gl::Texture& words() const { return words_[0]; }
  /// Of what is shown or tints it: the words that have its plane.
  [[nodiscard]] const gl::Texture& wordsOf(const RulePlane& shown) const {
    return shown.array == RuleArray::stage ? words_[0] : letWords_;
  }
  [[nodiscard]] int columns() const { return columns_; }

 private:
  struct Pass {
    gl::Kernel<RuleKernel> kernel;
    gl::Buffer told;
    std::vector<float> written;
  };
  [[nodiscard]] Pass& firstPass();
  void makeInputs(const std::string& name, const gl::Defines& defines);
  void paintInSpace(const ReactionPlan::Painted& painted);
  void step(long number, long first);
  /// Several steps, in strips.
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
  RuleCut cut_;
  std::string name_;
  bool mayStrip_ = false;
  gl::Defines stripDefines_;
  double cellSteps_ = 0;    ///< so far
  gl::Vec4Array cells_[2];  ///< now, and where the next step writes
  gl::Texture words_[2];
  gl::Vec4Array stages_[2];  ///< between the stages of a step
  gl::Vec4Array sums_, lets_, weights_;
  gl::Texture letWords_;
  gl::WordsArray stamps_, links_, places_;
  gl::Buffer status_;
  gl::Kernel<ReactionPaint> paint_;
  gl::Kernel<BrushKernel> brush_;  ///< in space
  std::map<std::pair<Field::Cells, bool>, gl::Kernel<SampleKernel>>
      samplers_;  ///< of other objects' fields; of volumes
  std::vector<Pass> passes_;
  gl::Kernel<StripKernel> strips_;
  gl::Kernel<LostKernel> lost_;
  gl::Buffer lostCells_;  ///< the lowest that is lost in each of some steps
  std::vector<float> values_;
};

}  // namespace simreel::sim
