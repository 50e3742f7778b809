#include "frame/mesh/ply.hpp"

#include "base/error.hpp"

#include <bit>
#include <cstring>

namespace simreel::frame {

static_assert(std::endian::native == std::endian::little, "floats are written as they lie in memory");

std::vector<std::byte> encodePly(std::span<const char* const> columns, std::span<const float> values,
                                 std::span<const std::string> comments) {
  return encodePly(columns, values, {}, comments);
}

std::vector<std::byte> encodePly(std::span<const char* const> columns, std::span<const float> values,
                                 std::span<const unsigned> indices, std::span<const std::string> comments) {
  SIMREEL_CHECK(!columns.empty() && values.size() % columns.size() == 0 && indices.size() % 3 == 0);
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments) {
    header += "comment ";
    for (const char c : comment) header += c == '\n' || c == '\r' ? ' ' : c;
    header += '\n';
  }
  header += fmt::format("element vertex {}\n", values.size() / columns.size());
  for (const char* column : columns) header += fmt::format("property float {}\n", column);
  if (!indices.empty())
    header += fmt::format("element face {}\nproperty list uchar uint vertex_indices\n", indices.size() / 3);
  header += "end_header\n";
  constexpr std::size_t faceBytes = 1 + 3 * sizeof(unsigned);
  std::vector<std::byte> file(header.size() + values.size_bytes() + indices.size() / 3 * faceBytes);
  std::memcpy(file.data(), header.data(), header.size());
  std::memcpy(file.data() + header.size(), values.data(), values.size_bytes());
  std::byte* face = file.data() + header.size() + values.size_bytes();
  for (std::size_t i = 0; i < indices.size(); i += 3, face += faceBytes) {
    *face = std::byte{3};
    std::memcpy(face + 1, &indices[i], 3 * sizeof(unsigned));
  }
  return file;
}

}  // namespace simreel::frame
