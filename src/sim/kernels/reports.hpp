#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/kernels/plan.hpp"

#include <string>
#include <vector>

namespace simreel::sim {

struct ReportsKernel;

/// Reads and writes out of bounds, and loops at their limit, of a user's kernels.
class KernelReports {
 public:
  /// `goesOn`: faults are told, and the run does not end.
  KernelReports(const std::string& name, const KernelPlan& plan, bool goesOn);
  ~KernelReports();
  KernelReports(const KernelReports&) = delete;
  KernelReports& operator=(const KernelReports&) = delete;

  /// Binds the reports of a kernel that is about to run `threads` invocations.
  void bind(std::size_t kernel, glm::uvec3 threads);
  /// Looks through the reports after a frame. Waits for nothing.
  void collect(long frame);
  /// As Simulation::status().
  [[nodiscard]] const gl::Buffer* status() const { return places_ == 0 ? nullptr : &status_; }
  /// One line on what was found first. Waits for the GPU.
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
