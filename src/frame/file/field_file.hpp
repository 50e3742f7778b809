#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::frame {

/// File format for the raw values of a field.
enum class FieldFormat {
  npy,  ///< NumPy array, version 1.0, little-endian float32, with the shape (rows, columns) and row 0 first
  pfm   ///< portable float map "Pf", little endian, with one channel and the last row first
};

/// Choice of field files by the option --fields.
struct FieldChoice {
  FieldFormat format = FieldFormat::npy;
  std::vector<std::string> names;  ///< names of fields, OBJECT or OBJECT.PART; if empty, all fields are
                                   ///< written
};
/// Parses a list such as "npy", "dish.u,dish.v" or "pfm,dish". Its items, separated by commas, are names of
/// fields and at most one format. Throws UserError(usage) for an empty item and for two formats.
[[nodiscard]] FieldChoice parseFieldChoice(const std::string& text);

/// Parses "npy" or "pfm". Throws UserError(usage) for other names.
[[nodiscard]] FieldFormat parseFieldFormat(const std::string& name);
/// Returns the file name extension, "npy" or "pfm".
[[nodiscard]] const char* extension(FieldFormat format);

/// Encodes field values as a file. Values are in row-major order, row 0 first; `size` is (columns, rows).
[[nodiscard]] std::vector<std::byte> encodeField(FieldFormat format, glm::ivec2 size,
                                                 std::span<const float> values);

}  // namespace simreel::frame
