#include "frame/mesh/obj.hpp"

#include <iterator>

#include <fmt/format.h>

namespace simreel::frame {

std::string encodeObj(const sim::MeshTable& mesh, std::span<const std::string> comments) {
  std::string text;
  const auto out = std::back_inserter(text);
  for (const std::string& comment : comments) {
    text += "# ";
    for (const char c : comment) text += c == '\n' || c == '\r' ? ' ' : c;
    text += '\n';
  }
  for (const glm::vec3& p : mesh.positions) fmt::format_to(out, "v {} {} {}\n", p.x, p.y, p.z);
  for (const glm::vec2& uv : mesh.uvs) fmt::format_to(out, "vt {} {}\n", uv.x, 1 - uv.y);
  for (const glm::vec3& n : mesh.normals) fmt::format_to(out, "vn {} {} {}\n", n.x, n.y, n.z);
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    text += 'f';
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t number = std::size_t{mesh.indices[i + k]} + 1;
      if (mesh.uvs.empty())
        fmt::format_to(out, " {0}//{0}", number);
      else
        fmt::format_to(out, " {0}/{0}/{0}", number);
    }
    text += '\n';
  }
  return text;
}

}  // namespace simreel::frame
