#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/port.hpp"
#include "sim/kernels/memory.hpp"
#include "sim/ports/measured.hpp"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace simreel::sim {

struct TakeKernel;

/// Fields and quantities of other objects that a user's kernels read, as at the start of a frame.
class KernelInputs {
 public:
  /// `links` may be null: then there is nothing to take.
  KernelInputs(const KernelPlan& plan, const scene::Object& object, const Links* links);
  ~KernelInputs();
  KernelInputs(const KernelInputs&) = delete;
  KernelInputs& operator=(const KernelInputs&) = delete;

  /// True if something is taken, so that the kernels cannot run before other objects exist.
  [[nodiscard]] bool any() const { return any_; }
  /// Copies fields into textures and reads quantities. `first`: also what is taken once, at the start.
  void update(KernelStore& store, bool first);
  [[nodiscard]] const std::vector<double>& quantities() const { return quantities_; }

 private:
  void fill(KernelStore& store, std::size_t texture, const Field& field);

  const KernelPlan& plan_;
  const Links* links_;
  bool any_ = false;
  QuantityReader reader_;
  std::vector<double> quantities_;
  std::map<std::pair<Field::Cells, int>, gl::Kernel<TakeKernel>> kernels_;
};

}  // namespace simreel::sim
