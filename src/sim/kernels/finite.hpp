#pragma once
#include "gl/buffer.hpp"
#include "sim/kernels/gather.hpp"
#include "sim/kernels/plan.hpp"

#include <string>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Reports about drawn elements of a user's kernels that are NaN or infinite.
class KernelFinite {
 public:
  enum class Part { surface, normals, points, velocities, field, terrain, volume, wind };
  static constexpr int parts = 8;

  KernelFinite(const std::string& name, const KernelPlan& plan, KernelDescription::NonFinite reaction);

  /// Returns the report entry that counts the elements of `part` that are not finite.
  [[nodiscard]] KernelWatch watch(Part part) const;
  [[nodiscard]] bool watches() const { return reaction_ != KernelDescription::NonFinite::ignore; }
  /// Returns true if a report does not end the run.
  [[nodiscard]] bool goesOn() const { return reaction_ == KernelDescription::NonFinite::warn; }
  /// Returns the reports, one per part: number of elements, first element, two unused words.
  [[nodiscard]] const gl::Buffer& reports() const { return reports_; }
  /// Returns one line about the report `words` of a part in a frame.
  [[nodiscard]] std::string message(int part, const glm::uvec4& words, unsigned frame) const;

 private:
  std::string name_;
  const KernelPlan& plan_;
  KernelDescription::NonFinite reaction_;
  gl::Buffer reports_;
};

}  // namespace simreel::sim
