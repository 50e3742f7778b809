#pragma once
#include "kernels/shader/shader.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

/// A value that a scene can set in an element of a buffer or in a constant block: a member without members.
struct KernelSlot {
  enum class Number { real, signedInteger, unsignedInteger, doubleReal };
  std::string path;  ///< "position", "material.color"; empty: the element itself
  std::string type;  ///< as the shader says it: "float3", "mat4", "float[4]"
  Number number = Number::real;
  bool used = true;                  ///< of constants: the kernel reads it
  std::vector<std::size_t> offsets;  ///< bytes of each component; of a matrix row by row

  [[nodiscard]] std::size_t width() const { return number == Number::doubleReal ? 8 : 4; }
};

/// Returns the slots of members, in their order.
[[nodiscard]] std::vector<KernelSlot> slotsOf(const std::vector<kernels::Member>& members);
/// Returns the slots of an element of an array: those of its struct, or itself under an empty path.
[[nodiscard]] std::vector<KernelSlot> slotsOfElement(const kernels::Member& array);
/// Returns the slot of that path; null if there is none.
[[nodiscard]] const KernelSlot* slotNamed(std::span<const KernelSlot> slots, std::string_view path);

/// Writes component number `i` of a slot into the memory that starts at `element`. Whole numbers are
/// rounded down and held to their range.
void storeSlot(std::byte* element, const KernelSlot& slot, std::size_t i, double value);
/// Returns component number `i`.
[[nodiscard]] double loadSlot(const std::byte* element, const KernelSlot& slot, std::size_t i);

}  // namespace simreel::sim
