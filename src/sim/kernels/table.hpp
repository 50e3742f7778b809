#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Table of numbers with named columns, read from a file of a scene.
struct KernelTable {
  std::vector<std::string> columns;
  std::vector<double> values;  ///< numbers of the table, row by row
  glm::ivec2 size{0, 0};       ///< width and height of an image or a grid; otherwise the number of rows,
                               ///< and 1

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
};

/// Reads a table: CSV (the first line names the columns), npy (columns c0, c1, ...), a mesh (x, y, z, nx,
/// ny, nz, u, v per vertex) or an image (linear r, g, b, a per pixel, from the top row). Throws UserError
/// with file and line.
[[nodiscard]] KernelTable readKernelTable(const std::filesystem::path& file);

/// Cache of tables by file, so that each file is read only once.
class KernelTables {
 public:
  /// Throws the same errors as readKernelTable().
  const KernelTable& of(const std::filesystem::path& file);
  /// Returns a table that has already been read, otherwise null.
  [[nodiscard]] const KernelTable* read(const std::filesystem::path& file) const;

 private:
  std::map<std::filesystem::path, std::shared_ptr<const KernelTable>> tables_;
};

}  // namespace simreel::sim
