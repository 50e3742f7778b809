#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::frame {

/// Files for the raw values of a field.
enum class FieldFormat {
  npy,  ///< NumPy array, version 1.0: little-endian float32 of shape (rows, columns), row 0 first
  pfm   ///< portable float map "Pf", little endian: one channel, last row first
};

/// "npy" or "pfm". Throws UserError(usage).
[[nodiscard]] FieldFormat parseFieldFormat(const std::string& name);
[[nodiscard]] const char* extension(FieldFormat format);  ///< "npy" or "pfm"

/// Values x fastest, row 0 first, as a file. `size` is columns and rows.
[[nodiscard]] std::vector<std::byte> encodeField(FieldFormat format, glm::ivec2 size,
                                                 std::span<const float> values);

}  // namespace simreel::frame
