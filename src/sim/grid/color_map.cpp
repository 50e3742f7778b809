#include "sim/grid/color_map.hpp"

#include "base/srgb.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/common.hpp>

namespace simreel::sim {

namespace {

/// Colour map of 33 evenly spaced sRGB stops, 0xRRGGBB. Every eighth stop is at a quarter of the map.
using Table = std::array<std::uint32_t, 33>;

constexpr Table viridis = {
    0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453681, 0x424086, 0x3f4989, 0x3b528b,
    0x375a8d, 0x33638d, 0x2f6a8e, 0x2c728e, 0x297a8e, 0x26818e, 0x23898e, 0x21908c, 0x1f988b,
    0x1f9f88, 0x21a685, 0x28ae80, 0x31b57b, 0x3ebc74, 0x4cc26c, 0x5dc963, 0x6ece58, 0x82d34c,
    0x96d83f, 0xabdc32, 0xc0df24, 0xd5e21a, 0xeae51a, 0xfde725,
};
constexpr Table magma = {
    0x000004, 0x030311, 0x0a0822, 0x130d33, 0x1d1146, 0x28115a, 0x36106a, 0x430f76, 0x50127c,
    0x5d177f, 0x691c81, 0x762181, 0x822681, 0x8f2a81, 0x9c2e7f, 0xa9327d, 0xb63779, 0xc33b75,
    0xcf4170, 0xdb486a, 0xe65163, 0xee5c5e, 0xf5695c, 0xf9785d, 0xfb8761, 0xfd9668, 0xfea571,
    0xfeb47b, 0xfec387, 0xfed194, 0xfde0a2, 0xfceeb0, 0xfcfdbf,
};
constexpr Table inferno = {
    0x000004, 0x040312, 0x0b0724, 0x150b37, 0x210c4a, 0x2e0a5a, 0x3c0965, 0x4a0c6b, 0x57106d,
    0x63146e, 0x70196e, 0x7d1e6d, 0x89226a, 0x962766, 0xa32b61, 0xaf315c, 0xbb3755, 0xc63e4d,
    0xd14644, 0xdb4f3b, 0xe35932, 0xeb6528, 0xf1711e, 0xf67f14, 0xf98d0a, 0xfb9c06, 0xfcab0f,
    0xfbba1f, 0xf9ca32, 0xf5d949, 0xf2e865, 0xf3f586, 0xfcffa4,
};
constexpr Table plasma = {
    0x0d0887, 0x220690, 0x310596, 0x3f049c, 0x4c02a1, 0x5901a5, 0x6600a7, 0x7201a8, 0x7e03a8,
    0x8909a6, 0x9511a2, 0x9f1a9c, 0xa92396, 0xb22c8e, 0xbb3587, 0xc33e80, 0xcb4778, 0xd25071,
    0xd9596a, 0xe06263, 0xe66c5c, 0xeb7555, 0xf07f4f, 0xf48a48, 0xf89441, 0xfb9f3a, 0xfdab33,
    0xfeb72d, 0xfdc328, 0xfcd025, 0xf9dd25, 0xf5eb27, 0xf0f921,
};
constexpr Table turbo = {
    0x30123b, 0x392a73, 0x4040a1, 0x4456c7, 0x466be3, 0x467ff6, 0x4293ff, 0x37a7fa, 0x29bbec,
    0x1dcdd8, 0x18dcc3, 0x1ee8b0, 0x31f299, 0x4cf97e, 0x6bfd64, 0x8aff4d, 0xa3fd3c, 0xb8f735,
    0xcced34, 0xdee037, 0xedd03a, 0xf8c03a, 0xfdae35, 0xfe982c, 0xfb8022, 0xf56817, 0xec520f,
    0xe04009, 0xd23105, 0xc02302, 0xac1701, 0x950d01, 0x7a0403,
};
/// Diverging map whose dark middle stands for zero. Lightness and hue in OKLab (Ottosson 2020) change
/// evenly towards both sides.
constexpr Table polar = {
    0xcdf4f6, 0xbfe3e7, 0x98d8e3, 0x6dcce1, 0x3bbee0, 0x12add8, 0x069cca, 0x098bbc, 0x067aad,
    0x066a9e, 0x035a8f, 0x034b7f, 0x013c70, 0x012e60, 0x002150, 0x01153c, 0x0d0d0d, 0x340204,
    0x4a0002, 0x5d0901, 0x6e1901, 0x7e2802, 0x8f3602, 0x9e4604, 0xae5504, 0xbd6507, 0xcd7606,
    0xd78926, 0xdb9f50, 0xdeb475, 0xe1c89a, 0xe6dac0, 0xf5ebce,
};
/// Grey scale in even steps in sRGB.
constexpr Table grey = [] {
  Table table{};
  for (std::uint32_t i = 0; i < table.size(); ++i) table[i] = 0x010101U * ((255U * i + 16U) / 32U);
  return table;
}();

struct Named {
  const char* name;
  const Table& table;
};
constexpr Named maps[] = {{"viridis", viridis}, {"magma", magma}, {"inferno", inferno}, {"plasma", plasma},
                          {"turbo", turbo},     {"polar", polar}, {"grey", grey}};

float linear(std::uint32_t byte) {
  return static_cast<float>(linearOfSrgb((byte & 255U) / 255.0));
}

}  // namespace

const std::vector<std::string>& colorMapNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Named& map : maps) all.emplace_back(map.name);
    return all;
  }();
  return names;
}

std::vector<glm::vec3> colorMapStops(const std::string& name) {
  std::vector<glm::vec3> stops;
  for (const Named& map : maps) {
    if (name != map.name) continue;
    for (const std::uint32_t rgb : map.table)
      stops.emplace_back(linear(rgb >> 16U), linear(rgb >> 8U), linear(rgb));
  }
  return stops;
}

std::vector<glm::vec4> paletteOf(const std::vector<glm::vec3>& stops, int count) {
  std::vector<glm::vec4> palette;
  for (int i = 0; i < count; ++i) {
    const float place =
        static_cast<float>(i) / static_cast<float>(count - 1) * static_cast<float>(stops.size() - 1);
    const auto left = std::min(static_cast<std::size_t>(place), stops.size() - 1);
    const auto right = std::min(left + 1, stops.size() - 1);
    palette.emplace_back(glm::mix(stops[left], stops[right], place - static_cast<float>(left)), 1);
  }
  return palette;
}

}  // namespace simreel::sim
