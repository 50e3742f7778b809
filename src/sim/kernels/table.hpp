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

/// Rows of numbers under names, read from a file of a scene.
struct KernelTable {
  std::vector<std::string> columns;
  std::vector<double> values;  ///< row by row
  glm::ivec2 size{0, 0};       ///< rows as they lie: of pictures width and height, else rows and 1

  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : values.size() / columns.size(); }
};

/// Reads CSV (the first line names the columns), npy (c0, c1, ...), a mesh (x, y, z, nx, ny, nz, u, v of
/// its vertices) or a picture (linear r, g, b and a, from the top row). Throws UserError with file and
/// line.
[[nodiscard]] KernelTable readKernelTable(const std::filesystem::path& file);

/// Tables by file, each read once.
class KernelTables {
 public:
  /// Throws as readKernelTable().
  const KernelTable& of(const std::filesystem::path& file);
  /// Returns a table that was read; null if it was not.
  [[nodiscard]] const KernelTable* read(const std::filesystem::path& file) const;

 private:
  std::map<std::filesystem::path, std::shared_ptr<const KernelTable>> tables_;
};

}  // namespace simreel::sim
