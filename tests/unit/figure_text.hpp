#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

/// Helpers that write glTF files with a skin.
namespace simreel::test {

class GltfText {
 public:
  /// Adds an array of numbers and its accessor. Returns the accessor's index.
  template <class T>
  std::size_t add(const std::vector<T>& numbers, int component, const char* type, std::size_t width,
                  bool normalized = false) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", numbers.size() * sizeof(T)}});
    bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T));
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", component},
                          {"count", numbers.size() / width},
                          {"type", type},
                          {"normalized", normalized}});
    return accessors_.size() - 1;
  }
  std::size_t floats(const std::vector<float>& numbers, const char* type, std::size_t width) {
    return add(numbers, 5126, type, width);
  }

  nlohmann::json document;  ///< the document without accessors, views and buffers

  [[nodiscard]] std::string text() const {
    nlohmann::json all = document;
    all["asset"] = {{"version", "2.0"}};
    all["accessors"] = accessors_;
    all["bufferViews"] = views_;
    all["buffers"] = {
        {{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    return all.dump();
  }

 private:
  static std::string base64(const std::string& bytes) {
    static constexpr const char* digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      std::uint32_t word = 0;
      for (std::size_t k = 0; k < 3; ++k)
        word = word << 8U | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
      for (int k = 3; k >= 0; --k) text += digits[word >> (6U * static_cast<unsigned>(k)) & 63U];
    }
    return text;
  }
  std::string bytes_;
  nlohmann::json views_ = nlohmann::json::array(), accessors_ = nlohmann::json::array();
};

/// Errors to insert into the tube of tubeText().
struct TubeFaults {
  bool noSkin = false, noWeights = false, noJoints = false;
  float weightSum = 1;
  std::uint8_t joint = 1;  ///< index of the joint that moves the upper half
  std::vector<float> times = {0, 0.5F, 1};
};

/// Returns a tube of radius 0.1 m and length 1 m along y. Its joint "low" is at the lower end. "high" is in
/// the middle and moves the upper half, with a gradual transition. "tip" is at the upper end and moves
/// nothing. There are three animations. "bend" rotates "high" about z by 0, 90, 0 degrees at 0, 0.5 and 1
/// s, and moves "low" along x by 0, 1, 0 m. "step" moves "high" with STEP interpolation. "curve" moves
/// "high" with CUBICSPLINE interpolation and constant tangents (1, 2, 3) per second.
inline GltfText tubeText(const TubeFaults& faults = {}) {
  constexpr int around = 24;
  constexpr int rings = 41;
  constexpr float radius = 0.1F;
  GltfText gltf;
  std::vector<float> positions, normals, weights;
  std::vector<std::uint8_t> joints;
  std::vector<std::uint16_t> indices;
  for (int ring = 0; ring < rings; ++ring)
    for (int k = 0; k < around; ++k) {
      const float angle = 6.2831853F * static_cast<float>(k) / around;
      const float y = static_cast<float>(ring) / (rings - 1);
      positions.insert(positions.end(), {radius * std::cos(angle), y, radius * std::sin(angle)});
      normals.insert(normals.end(), {std::cos(angle), 0, std::sin(angle)});
      const float upper = std::min(std::max((y - 0.4F) / 0.2F, 0.0F), 1.0F);
      weights.insert(weights.end(), {(1 - upper) * faults.weightSum, upper * faults.weightSum, 0, 0});
      joints.insert(joints.end(), {0, faults.joint, 0, 0});
      if (ring + 1 == rings) continue;
      const auto at = [&](int r, int c) { return static_cast<std::uint16_t>(r * around + c % around); };
      for (const std::uint16_t corner : {at(ring, k), at(ring + 1, k), at(ring, k + 1), at(ring, k + 1),
                                         at(ring + 1, k), at(ring + 1, k + 1)})
        indices.push_back(corner);
    }
  nlohmann::json attributes = {{"POSITION", gltf.floats(positions, "VEC3", 3)},
                               {"NORMAL", gltf.floats(normals, "VEC3", 3)}};
  if (!faults.noJoints) attributes["JOINTS_0"] = gltf.add(joints, 5121, "VEC4", 4);
  if (!faults.noWeights) attributes["WEIGHTS_0"] = gltf.floats(weights, "VEC4", 4);
  std::vector<float> binds;
  for (const float y : {0.0F, 0.5F, 1.0F})
    binds.insert(binds.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -y, 0, 1});
  auto& d = gltf.document;
  d["scene"] = 0;
  d["scenes"] = {{{"nodes", {0, 3}}}};
  d["nodes"] = {{{"name", "low"}, {"children", {1}}},
                {{"name", "high"}, {"children", {2}}, {"translation", {0, 0.5, 0}}},
                {{"name", "tip"}, {"translation", {0, 0.5, 0}}},
                {{"name", "tube"}, {"mesh", 0}, {"skin", 0}}};
  if (faults.noSkin) d["nodes"][3].erase("skin");
  d["meshes"] = {
      {{"primitives", {{{"attributes", attributes}, {"indices", gltf.add(indices, 5123, "SCALAR", 1)}}}}}};
  d["skins"] = {{{"joints", {0, 1, 2}}, {"inverseBindMatrices", gltf.floats(binds, "MAT4", 16)}}};
  const std::size_t times = gltf.floats(faults.times, "SCALAR", 1);
  const float half = 0.70710678F;
  const std::size_t turns = gltf.floats({0, 0, 0, 1, 0, 0, half, half, 0, 0, 0, 1}, "VEC4", 4);
  const std::size_t moves = gltf.floats({0, 0, 0, 1, 0, 0, 0, 0, 0}, "VEC3", 3);
  std::vector<float> curve;
  for (const float y : {0.5F, 0.7F, 0.5F}) curve.insert(curve.end(), {1, 2, 3, 0, y, 0, 1, 2, 3});
  const std::size_t cubic = gltf.floats(curve, "VEC3", 3);
  const auto motion = [](const char* name, std::vector<nlohmann::json> parts) {
    nlohmann::json one = {{"name", name}};
    for (nlohmann::json& part : parts) {
      one["channels"].push_back({{"sampler", one["samplers"].size()},
                                 {"target", {{"node", part["node"]}, {"path", part["path"]}}}});
      part.erase("node");
      part.erase("path");
      one["samplers"].push_back(part);
    }
    return one;
  };
  d["animations"] = {
      motion("bend", {{{"node", 1}, {"path", "rotation"}, {"input", times}, {"output", turns}},
                      {{"node", 0}, {"path", "translation"}, {"input", times}, {"output", moves}}}),
      motion("step", {{{"node", 1},
                       {"path", "rotation"},
                       {"input", times},
                       {"output", turns},
                       {"interpolation", "STEP"}}}),
      motion("curve", {{{"node", 1},
                        {"path", "translation"},
                        {"input", times},
                        {"output", cubic},
                        {"interpolation", "CUBICSPLINE"}}})};
  return gltf;
}

}  // namespace simreel::test
