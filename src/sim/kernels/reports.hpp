#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/kernels/plan.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

struct ReportsKernel;

/// Collects reports of a user's kernels about out-of-bounds accesses and about loops that reach their
/// iteration limit.
class KernelReports {
 public:
  /// If `goesOn` is true, faults are reported but do not end the run.
  KernelReports(const std::string& name, const KernelPlan& plan, bool goesOn);
  ~KernelReports();
  KernelReports(const KernelReports&) = delete;
  KernelReports& operator=(const KernelReports&) = delete;

  /// Binds the report buffer of a kernel. Call it before the kernel runs `threads` invocations.
  void bind(std::size_t kernel, glm::uvec3 threads);
  /// Collects the reports of a frame on the GPU, without waiting for the GPU.
  void collect(long frame);
  /// See Simulation::status().
  [[nodiscard]] const gl::Buffer* status() const { return places_ == 0 ? nullptr : &status_; }
  /// Returns one line about the first fault. Waits for the GPU.
  [[nodiscard]] std::string told() const;

 private:
  std::string name_;
  const KernelPlan& plan_;
  bool goesOn_;
  std::size_t places_ = 0;
  std::vector<gl::Buffer> reports_;
  std::vector<glm::uvec3> threads_;
  gl::Buffer status_, caught_;
  gl::Kernel<ReportsKernel> kernel_;
};

}  // namespace simreel::sim
