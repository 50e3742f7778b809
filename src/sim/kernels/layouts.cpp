#include "sim/kernels/layouts.hpp"

#include <utility>

namespace simreel::sim {

namespace {

std::vector<std::size_t> shapeOf(const glm::ivec3& size) {
  std::vector<std::size_t> shape = {static_cast<std::size_t>(size.x)};
  if (size.y > 1 || size.z > 1) shape.insert(shape.begin(), static_cast<std::size_t>(size.y));
  if (size.z > 1) shape.insert(shape.begin(), static_cast<std::size_t>(size.z));
  return shape;
}

StateMember::Number numberOf(const KernelSlot& slot) {
  switch (slot.number) {
    case KernelSlot::Number::signedInteger:
      return StateMember::Number::int32;
    case KernelSlot::Number::unsignedInteger:
      return StateMember::Number::uint32;
    case KernelSlot::Number::doubleReal:
      return StateMember::Number::float64;
    case KernelSlot::Number::real:
      break;
  }
  return StateMember::Number::float32;
}

bool hasGaps(const KernelSlot& slot) {
  for (std::size_t i = 1; i < slot.offsets.size(); ++i)
    if (slot.offsets[i] != slot.offsets[0] + i * slot.width()) return true;
  return false;
}

/// Adds a slot as one member, or as a member for each component if there are gaps between them, as in some
/// matrices.
void add(std::vector<StateMember>& members, const KernelSlot& slot) {
  if (slot.offsets.empty()) return;
  StateMember member{slot.path, numberOf(slot), {}, slot.offsets.front()};
  if (!hasGaps(slot)) {
    if (slot.offsets.size() > 1) member.shape = {slot.offsets.size()};
    members.push_back(std::move(member));
    return;
  }
  for (std::size_t i = 0; i < slot.offsets.size(); ++i) {
    member.name = slot.path + "[" + std::to_string(i) + "]";
    member.offset = slot.offsets[i];
    members.push_back(member);
  }
}

std::size_t channelsOf(const std::string& format) {
  if (format.starts_with("rgba") || format.starts_with("rgb10")) return 4;
  if (format.starts_with("r11")) return 3;
  return format.starts_with("rg") ? 2 : 1;
}

}  // namespace

StateLayout layoutOf(const PlannedBuffer& buffer) {
  const bool fixed = buffer.element.empty();
  StateLayout layout{shapeOf(buffer.size), buffer.header, buffer.stride, {}};
  if (fixed) layout = {{1}, 0, buffer.header, {}};
  for (const KernelSlot& slot : fixed ? buffer.fixed : buffer.element) add(layout.members, slot);
  return layout;
}

StateLayout layoutOf(const PlannedTexture& texture) {
  using Number = StateMember::Number;
  const Number number = !texture.integers()              ? Number::float32
                        : texture.format.ends_with("ui") ? Number::uint32
                                                         : Number::int32;
  return {shapeOf(texture.size), 0, 16, {{"", number, {channelsOf(texture.format)}, 0}}};
}

}  // namespace simreel::sim
