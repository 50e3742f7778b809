#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::frame {

/// File format for the raw values of a field.
enum class FieldFormat {
  npy,  ///< NumPy array, version 1.0: little-endian float32 of shape (rows, columns), row 0 first
  pfm   ///< portable float map "Pf", little endian: one channel, last row first
};

/// Parses "npy" or "pfm". Throws UserError(usage) for other names.
[[nodiscard]] FieldFormat parseFieldFormat(const std::string& name);
/// Returns the file name extension, "npy" or "pfm".
[[nodiscard]] const char* extension(FieldFormat format);

/// Encodes field values as a file. Values are in row-major order, row 0 first; `size` is (columns, rows).
[[nodiscard]] std::vector<std::byte> encodeField(FieldFormat format, glm::ivec2 size,
                                                 std::span<const float> values);

}  // namespace simreel::frame
