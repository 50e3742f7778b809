#include "kernels/spirv/optimize.hpp"

#include <spirv-tools/optimizer.hpp>
#include <stdexcept>
#include <string>

namespace simreel::kernels {

Words optimized(const Words& words, bool legalize) {
  spvtools::Optimizer optimizer(SPV_ENV_UNIVERSAL_1_3);
  std::string message;
  optimizer.SetMessageConsumer(
      [&](spv_message_level_t level, const char*, const spv_position_t&, const char* text) {
        if (level <= SPV_MSG_ERROR && message.empty()) message = text;
      });
  optimizer.RegisterPass(spvtools::CreateFreezeSpecConstantValuePass());
  optimizer.RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass());
  optimizer.RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
  if (legalize) optimizer.RegisterLegalizationPasses();
  optimizer.RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
  optimizer.RegisterPass(spvtools::CreateDeadVariableEliminationPass());
  optimizer.RegisterPass(spvtools::CreateEliminateDeadConstantPass());
  spvtools::OptimizerOptions options;
  options.set_run_validator(false);
  Words made;
  if (!optimizer.Run(words.data(), words.size(), &made, options))
    throw std::runtime_error(message.empty() ? "SPIRV-Tools cannot read the shader" : message);
  return made;
}

}  // namespace simreel::kernels
