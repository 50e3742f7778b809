#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::frame {

/// Encodes points as PLY (binary, little endian, 32-bit floats). `values`: all rows, one after another,
/// with one value per column. Each comment becomes a header line.
[[nodiscard]] std::vector<std::byte> encodePly(std::span<const char* const> columns,
                                               std::span<const float> values,
                                               std::span<const std::string> comments);

/// Encodes points and triangles as PLY. `indices`: three row indices per triangle.
[[nodiscard]] std::vector<std::byte> encodePly(std::span<const char* const> columns,
                                               std::span<const float> values,
                                               std::span<const unsigned> indices,
                                               std::span<const std::string> comments);

}  // namespace simreel::frame
