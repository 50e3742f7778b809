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

/// Fields and quantities of other objects that a user's kernels read, in their state at the start of a
/// frame.
class KernelInputs {
 public:
  /// `links` may be null; then the kernels read nothing from other objects.
  KernelInputs(const KernelPlan& plan, const scene::Object& object, const Links* links);
  ~KernelInputs();
  KernelInputs(const KernelInputs&) = delete;
  KernelInputs& operator=(const KernelInputs&) = delete;

  /// Returns true if the kernels read something from other objects, so that they cannot run before these
  /// exist.
  [[nodiscard]] bool any() const { return any_; }
  /// Copies fields into textures and reads quantities. If `first` is true, also copies the fields that are
  /// read only once, at the start.
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
