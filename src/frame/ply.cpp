#include "frame/ply.hpp"

#include "base/error.hpp"

#include <bit>
#include <cstring>

namespace simreel::frame {

static_assert(std::endian::native == std::endian::little, "floats are written as they lie in memory");

std::vector<std::byte> encodePly(std::span<const char* const> columns, std::span<const float> values,
                                 std::span<const std::string> comments) {
  SIMREEL_CHECK(!columns.empty() && values.size() % columns.size() == 0);
  std::string header = "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments) {
    header += "comment ";
    for (const char c : comment) header += c == '\n' || c == '\r' ? ' ' : c;
    header += '\n';
  }
  header += fmt::format("element vertex {}\n", values.size() / columns.size());
  for (const char* column : columns) header += fmt::format("property float {}\n", column);
  header += "end_header\n";
  std::vector<std::byte> file(header.size() + values.size_bytes());
  std::memcpy(file.data(), header.data(), header.size());
  std::memcpy(file.data() + header.size(), values.data(), values.size_bytes());
  return file;
}

}  // namespace simreel::frame
