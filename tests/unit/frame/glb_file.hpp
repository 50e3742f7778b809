#pragma once
#include "base/file.hpp"

#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace simreel::frame::test {

/// Reader of a binary glTF file with one buffer. It uses only the rules of the glTF 2.0 specification,
/// independently of any library. Comments name the sections of these rules.
class GlbFile {
 public:
  explicit GlbFile(const std::filesystem::path& file) : bytes_(readFile(file, "glTF file")) {
    // By glTF 4.4, a file has a header, a JSON chunk and a binary chunk. Their sizes are multiples of 4
    // bytes.
    REQUIRE(bytes_.size() > 28);
    REQUIRE(bytes_.substr(0, 4) == "glTF");
    REQUIRE(word(4) == 2);
    REQUIRE(word(8) == bytes_.size());
    const std::size_t json = word(12);
    REQUIRE(bytes_.substr(16, 4) == "JSON");
    REQUIRE(json % 4 == 0);
    document_ = nlohmann::json::parse(bytes_.substr(20, json));
    REQUIRE(bytes_.substr(24 + json, 4) == std::string("BIN\0", 4));
    binary_ = 28 + json;
    REQUIRE(word(20 + json) == bytes_.size() - binary_);
    REQUIRE(document_["asset"]["version"] == "2.0");
    REQUIRE(document_["buffers"].size() == 1);
    REQUIRE(document_["buffers"][0]["byteLength"] == bytes_.size() - binary_);
  }

  [[nodiscard]] const nlohmann::json& document() const { return document_; }

  /// Returns the values of an accessor: floats, or indices (3.6.2.2: component type 5125).
  template <class T>
  [[nodiscard]] std::vector<T> values(const nlohmann::json& number) const {
    const nlohmann::json& accessor = document_["accessors"].at(number.get<std::size_t>());
    const nlohmann::json& view = document_["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    REQUIRE(accessor["componentType"] == (std::is_same_v<T, float> ? 5126 : 5125));
    const std::string type = accessor["type"];
    const std::size_t width = type == "VEC3" ? 3 : type == "VEC2" ? 2 : 1;
    const std::size_t count = accessor["count"];
    const std::size_t begin = accessor.value("byteOffset", std::size_t{0});
    const std::size_t stride = view.value("byteStride", width * sizeof(T));
    // By glTF 3.6.2.4, rows are aligned to 4 bytes and the last row ends within the view.
    REQUIRE(begin % 4 == 0);
    REQUIRE(begin + stride * (count - 1) + width * sizeof(T) <= view["byteLength"]);
    std::vector<T> found(width * count);
    for (std::size_t i = 0; i < count; ++i)
      std::memcpy(&found[width * i],
                  &bytes_.at(binary_ + view["byteOffset"].get<std::size_t>() + begin + stride * i),
                  width * sizeof(T));
    return found;
  }

  /// Returns rows of three floats. If the accessor has bounds, checks that they equal the min and max of
  /// the accessor's values (3.6.2.5).
  [[nodiscard]] std::vector<glm::vec3> rows(const nlohmann::json& number) const {
    const std::vector<float> flat = values<float>(number);
    std::vector<glm::vec3> found;
    glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
    for (std::size_t i = 0; i + 2 < flat.size(); i += 3) {
      found.emplace_back(flat[i], flat[i + 1], flat[i + 2]);
      low = glm::min(low, found.back());
      high = glm::max(high, found.back());
    }
    const nlohmann::json& accessor = document_["accessors"].at(number.get<std::size_t>());
    if (accessor.contains("min"))
      for (int k = 0; k < 3; ++k) {
        CHECK(accessor["min"][k].get<float>() == low[k]);
        CHECK(accessor["max"][k].get<float>() == high[k]);
      }
    return found;
  }

 private:
  [[nodiscard]] std::uint32_t word(std::size_t at) const {
    std::uint32_t value = 0;
    std::memcpy(&value, &bytes_.at(at), sizeof value);
    return value;
  }

  std::string bytes_;
  std::size_t binary_ = 0;
  nlohmann::json document_;
};

}  // namespace simreel::frame::test
