#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "sim/kernels/memory.hpp"
#include "sim/kernels/plan.hpp"

#include <memory>
#include <string>
#include <vector>

namespace simreel::sim {

/// Owns the compiled kernels of one shader and their uniform blocks.
class KernelPrograms {
 public:
  /// Compiles the kernels of all requests for the arithmetic of the current context's driver.
  KernelPrograms(const std::string& name, const std::vector<kernels::Request>& requests);

  [[nodiscard]] const kernels::Kernel& kernel(int place) const {
    return kernels_[static_cast<std::size_t>(place)];
  }
  /// Returns the workgroup counts of an entry; 1 for an indirect dispatch.
  [[nodiscard]] static glm::uvec3 groups(const KernelPlan& plan, const PlannedEntry& entry,
                                         const KernelPlan::Now& now);
  /// Runs an entry's kernel. All other bindings (reports, shadows) must already be bound. Throws
  /// UserError(device) for more than 2^31 invocations.
  void dispatch(KernelStore& store, const PlannedEntry& entry, const KernelPlan::Now& now);

 private:
  struct UniformBlock {
    gl::Buffer buffer;
    std::vector<std::byte> bytes;  ///< content of the buffer; empty before the first dispatch
  };

  void checkGroupCount(const kernels::Kernel& kernel, const glm::uvec3& groups) const;

  std::string name_;
  std::vector<kernels::Kernel> kernels_;
  std::vector<gl::Program> programs_;
  std::vector<std::vector<UniformBlock>> blocks_;
};

}  // namespace simreel::sim
