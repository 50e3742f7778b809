#pragma once
#include "base/error.hpp"
#include "sim/mesh/file/mesh_file.hpp"
#include "unit/help.hpp"

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace simreel::test {

/// A glTF file that is built from lists of floats, each with an accessor.
class FloatGltf {
 public:
  FloatGltf() {
    json = {{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0}}}}},
            {"nodes", {{{"mesh", 0}}}}};
  }

  int add(const std::vector<float>& values, const char* type, std::size_t each) {
    json["accessors"].push_back(
        {{"bufferView", views_}, {"componentType", 5126}, {"count", values.size() / each}, {"type", type}});
    json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", 4 * values.size()}});
    for (const float value : values)
      for (unsigned shift = 0; shift < 32; shift += 8)
        bytes_ += static_cast<char>(std::bit_cast<std::uint32_t>(value) >> shift & 255U);
    return views_++;
  }

  [[nodiscard]] std::string text() {
    json["buffers"] = {
        {{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64()}}};
    if (!fallback.empty()) json["buffers"].push_back(fallback);
    return json.dump();
  }
  [[nodiscard]] sim::Mesh mesh() {
    const TemporaryFile file("polygons.gltf", text());
    return sim::importMesh(file.path());
  }
  [[nodiscard]] std::string refusal() {
    try {
      static_cast<void>(mesh());
    } catch (const UserError& error) {
      return error.what();
    }
    return "nothing was refused";
  }

  nlohmann::json json;
  nlohmann::json fallback;  ///< content of the document's second buffer

 private:
  [[nodiscard]] std::string base64() const {
    std::string out;
    for (std::size_t i = 0; i < bytes_.size(); i += 3) {
      std::uint32_t bits = 0;
      for (std::size_t k = 0; k < 3; ++k)
        bits = bits << 8U | (i + k < bytes_.size() ? static_cast<unsigned char>(bytes_[i + k]) : 0U);
      for (unsigned k = 0; k < 4; ++k)
        out +=
            i + k > bytes_.size()
                ? '='
                : "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"[bits >> (18 - 6 * k) &
                                                                                     63U];
    }
    return out;
  }

  std::string bytes_;
  int views_ = 0;
};

}  // namespace simreel::test
