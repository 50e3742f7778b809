#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace simreel::frame {

/// Points as a PLY file (binary, little endian, 32-bit floats): `values` row by row, one value a column.
/// The comments go into the header, a line each.
[[nodiscard]] std::vector<std::byte> encodePly(std::span<const char* const> columns,
                                               std::span<const float> values,
                                               std::span<const std::string> comments);

/// The same with triangles over the rows: three indices each.
[[nodiscard]] std::vector<std::byte> encodePly(std::span<const char* const> columns,
                                               std::span<const float> values,
                                               std::span<const unsigned> indices,
                                               std::span<const std::string> comments);

}  // namespace simreel::frame
