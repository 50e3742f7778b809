#include "sim/kernels/slots.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

using Number = KernelSlot::Number;

/// Shape of a scalar, vector or matrix type of HLSL or GLSL.
struct Shape {
  Number number = Number::real;
  std::size_t rows = 1, columns = 1;  ///< numbers of rows and columns; a vector has one column
};

Shape shapeOf(const std::string& type) {
  Shape shape;
  const bool vectorOfGlsl = type.find("vec") != std::string::npos;
  if (type.starts_with("uint") || type.starts_with("uvec") || type.starts_with("bool") ||
      type.starts_with("bvec"))
    shape.number = Number::unsignedInteger;
  else if (type.starts_with("int") || type.starts_with("ivec"))
    shape.number = Number::signedInteger;
  else if (type.starts_with("double") || type.starts_with("dvec") || type.starts_with("dmat"))
    shape.number = Number::doubleReal;
  const auto digit = [&](std::size_t at) { return static_cast<std::size_t>(type[at] - '0'); };
  const std::size_t last = type.size() - 1;
  if (type.size() > 3 && type[last - 1] == 'x' && type[last] >= '1' && type[last] <= '4') {
    const bool hlsl = !type.starts_with("mat") && !type.starts_with("dmat");  // the type float3x4 of HLSL
                                                                              // is rows x columns
    shape.rows = digit(hlsl ? last - 2 : last);
    shape.columns = digit(hlsl ? last : last - 2);
  } else if (type[last] >= '1' && type[last] <= '4') {
    shape.rows = digit(last);
    if (!vectorOfGlsl && type.find("mat") != std::string::npos) shape.columns = shape.rows;
  }
  return shape;
}

void addSlots(const kernels::Member& member, const std::string& path, std::size_t base,
              std::vector<KernelSlot>& slots);

void addMembers(const std::vector<kernels::Member>& members, const std::string& path, std::size_t base,
                std::vector<KernelSlot>& slots) {
  for (const kernels::Member& member : members) {
    const std::size_t before = slots.size();
    addSlots(member, path.empty() ? member.name : path + "." + member.name, base + member.offset, slots);
    for (std::size_t i = before; i < slots.size(); ++i) slots[i].used = slots[i].used && member.used;
  }
}

/// Returns the byte offset of each component of a value, in row order. Matrices are stored column by
/// column.
std::vector<std::size_t> componentsOf(const Shape& shape, std::size_t bytes, std::size_t base) {
  const std::size_t width = shape.number == Number::doubleReal ? 8 : 4;
  const std::size_t stride = shape.columns > 1 ? bytes / shape.columns : 0;
  std::vector<std::size_t> offsets;
  for (std::size_t row = 0; row < shape.rows; ++row)
    for (std::size_t column = 0; column < shape.columns; ++column)
      offsets.push_back(base + column * stride + row * width);
  return offsets;
}

void addSlots(const kernels::Member& member, const std::string& path, std::size_t base,
              std::vector<KernelSlot>& slots) {
  std::size_t count = 1;
  for (const std::size_t length : member.array) count *= length;
  if (!member.members.empty()) {
    if (member.array.empty()) return addMembers(member.members, path, base, slots);
    for (std::size_t i = 0; i < count; ++i)
      addMembers(member.members, fmt::format("{}[{}]", path, i), base + i * member.stride, slots);
    return;
  }
  const Shape shape = shapeOf(member.type);
  KernelSlot slot{path, member.type, shape.number, true, {}};
  for (const std::size_t length : member.array) slot.type += fmt::format("[{}]", length);
  for (std::size_t i = 0; i < count; ++i) {
    const auto offsets = componentsOf(shape, member.bytes, base + i * member.stride);
    slot.offsets.insert(slot.offsets.end(), offsets.begin(), offsets.end());
  }
  slot.elements = count;
  slots.push_back(std::move(slot));
}

template <class Integer>
void storeInteger(std::byte* at, double value) {
  const double low = std::numeric_limits<Integer>::min(), high = std::numeric_limits<Integer>::max();
  const auto whole = static_cast<Integer>(std::clamp(std::floor(std::isnan(value) ? 0 : value), low, high));
  std::memcpy(at, &whole, sizeof whole);
}

template <class T>
double loadAs(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return static_cast<double>(value);
}

}  // namespace

std::vector<KernelSlot> slotsOf(const std::vector<kernels::Member>& members) {
  std::vector<KernelSlot> slots;
  addMembers(members, "", 0, slots);
  return slots;
}

std::vector<KernelSlot> slotsOfElement(const kernels::Member& array) {
  kernels::Member element = array;
  element.array.erase(element.array.begin());
  std::vector<KernelSlot> slots;
  addSlots(element, "", 0, slots);
  return slots;
}

std::vector<std::string> pathsOf(std::span<const KernelSlot> slots) {
  std::vector<std::string> paths;
  paths.reserve(slots.size());
  for (const KernelSlot& slot : slots) paths.push_back(slot.path);
  return paths;
}

const KernelSlot* slotNamed(std::span<const KernelSlot> slots, std::string_view path) {
  const auto found =
      std::find_if(slots.begin(), slots.end(), [&](const KernelSlot& s) { return s.path == path; });
  return found == slots.end() ? nullptr : &*found;
}

void storeSlot(std::byte* element, const KernelSlot& slot, std::size_t i, double value) {
  std::byte* at = element + slot.offsets[i];
  switch (slot.number) {
    case Number::signedInteger:
      return storeInteger<std::int32_t>(at, value);
    case Number::unsignedInteger:
      return storeInteger<std::uint32_t>(at, value);
    case Number::doubleReal:
      std::memcpy(at, &value, sizeof value);
      return;
    case Number::real:
      break;
  }
  const auto single = static_cast<float>(value);
  std::memcpy(at, &single, sizeof single);
}

std::string whyTooLarge(const KernelSlot& slot, double value) {
  constexpr float maximum = std::numeric_limits<float>::max();
  if (slot.number != Number::real || !(std::abs(value) > static_cast<double>(maximum))) return {};
  return fmt::format("{} is a {}, which holds numbers up to {:.3g}; found {:g}",
                     slot.path.empty() ? "an element" : "\"" + slot.path + "\"", slot.type, maximum, value);
}

double loadSlot(const std::byte* element, const KernelSlot& slot, std::size_t i) {
  const std::byte* at = element + slot.offsets[i];
  switch (slot.number) {
    case Number::signedInteger:
      return loadAs<std::int32_t>(at);
    case Number::unsignedInteger:
      return loadAs<std::uint32_t>(at);
    case Number::doubleReal:
      return loadAs<double>(at);
    case Number::real:
      break;
  }
  return loadAs<float>(at);
}

}  // namespace simreel::sim
