#pragma once
#include "api/simreel/values.hpp"

#include <cstddef>
#include <vector>

namespace simreel::api {

/// Returns the strides in bytes of an array without gaps.
[[nodiscard]] std::vector<std::size_t> denseStrides(const std::vector<std::size_t>& shape,
                                                    std::size_t numberBytes);

/// Makes an array without gaps from numbers of four bytes.
template <class T>
[[nodiscard]] Array denseArray(std::string name, std::string unit, NumberType type,
                               std::vector<std::size_t> shape, const std::vector<T>& values) {
  const auto* begin = reinterpret_cast<const std::byte*>(values.data());
  std::vector<std::size_t> strides = denseStrides(shape, 4);
  return {std::move(name),  std::move(unit),    type,
          std::move(shape), std::move(strides), {begin, begin + values.size() * sizeof(T)}};
}

}  // namespace simreel::api
