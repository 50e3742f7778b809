#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/kernels/finite.hpp"
#include "sim/kernels/plan.hpp"

#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

struct ReportsKernel;

/// Collects out-of-bounds accesses, loops that reach their limit, and drawn numbers that are not finite.
class KernelReports {
 public:
  /// If `goesOn` is true, out-of-bounds accesses and loops at their limit are reported but do not end the
  /// run.
  KernelReports(const std::string& name, const KernelPlan& plan, const KernelFinite& finite, bool goesOn);
  ~KernelReports();
  KernelReports(const KernelReports&) = delete;
  KernelReports& operator=(const KernelReports&) = delete;

  /// Binds the report buffer of a kernel. Call it before the kernel runs `threads` invocations.
  void bind(std::size_t kernel, glm::uvec3 threads);
  /// Collects the reports of a frame on the GPU, without waiting for the GPU.
  void collect(long frame);
  /// See Simulation::status().
  [[nodiscard]] const gl::Buffer* status() const {
    return places_ > 0 || finite_.watches() ? &status_ : nullptr;
  }
  /// Returns one line about the first fault. Waits for the GPU.
  [[nodiscard]] std::string message() const;
  /// Returns one line about the report that ended the run, by its index in the status.
  [[nodiscard]] std::string message(unsigned report) const;

 private:
  [[nodiscard]] std::string messageOfKernels(std::span<const glm::uvec4> words, unsigned frame) const;

  std::string name_;
  const KernelPlan& plan_;
  const KernelFinite& finite_;
  bool goesOn_;
  std::size_t places_ = 0;
  std::vector<gl::Buffer> reports_;
  std::vector<glm::uvec3> threads_;
  gl::Buffer status_, caught_;
  gl::Kernel<ReportsKernel> kernel_;
};

}  // namespace simreel::sim
