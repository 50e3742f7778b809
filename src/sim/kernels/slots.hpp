#pragma once
#include "kernels/shader/shader.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::sim {

/// Value that a scene can set in a buffer element or a constant block: a member that is not a struct.
struct KernelSlot {
  enum class Number { real, signedInteger, unsignedInteger, doubleReal };
  std::string path;  ///< path of the member, for example "position" or "material.color"; empty for the
                     ///< element itself
  std::string type;  ///< type name in the shader: "float3", "mat4", "float[4]"
  Number number = Number::real;
  bool used = true;                  ///< for constants only: true if the kernel reads the value
  std::vector<std::size_t> offsets;  ///< byte offset of each component; the components of a matrix are in
                                     ///< row order
  std::size_t elements = 1;          ///< number of array elements; each has an equal share of `offsets`

  [[nodiscard]] std::size_t width() const { return number == Number::doubleReal ? 8 : 4; }
};

/// Returns the slots of all members in order.
[[nodiscard]] std::vector<KernelSlot> slotsOf(const std::vector<kernels::Member>& members);
/// Returns the slots of an array element: the slots of its struct, or a single slot with an empty path.
[[nodiscard]] std::vector<KernelSlot> slotsOfElement(const kernels::Member& array);
/// Returns the paths of slots, as scenes name them.
[[nodiscard]] std::vector<std::string> pathsOf(std::span<const KernelSlot> slots);
/// Returns the slot with this path, or null if none exists.
[[nodiscard]] const KernelSlot* slotNamed(std::span<const KernelSlot> slots, std::string_view path);

/// Returns why a slot cannot hold a number of a scene; empty if it can. A float holds no number
/// beyond 3.4e38.
[[nodiscard]] std::string whyTooLarge(const KernelSlot& slot, double value);

/// Writes component `i` (zero-based) of a slot in the element at the address `element`. For integer types,
/// the value is rounded down and clamped to the type's range.
void storeSlot(std::byte* element, const KernelSlot& slot, std::size_t i, double value);
/// Returns component `i` (zero-based) of a slot.
[[nodiscard]] double loadSlot(const std::byte* element, const KernelSlot& slot, std::size_t i);

}  // namespace simreel::sim
