#include "frame/file/map_pictures.hpp"

#include "base/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace simreel::frame {

namespace {

std::uint8_t byteOf(float fraction) {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(fraction, 0.0F, 1.0F)));
}

template <class ColorOf>
std::vector<std::byte> picture(const draw::SkinMaps& maps, const std::vector<glm::vec4>& texels,
                               const ImageText& text, ColorOf colorOf) {
  Image image{maps.size.x, maps.size.y, {}};
  image.bytes.reserve(texels.size() * 4);
  for (const glm::vec4& texel : texels) {
    const glm::vec3 color = colorOf(texel);
    for (int i = 0; i < 3; ++i) image.bytes.push_back(byteOf(color[i]));
    image.bytes.push_back(255);
  }
  return encodePng(image, text);
}

glm::vec3 encodedColor(const glm::vec3& linear) {
  const auto channel = [](float x) { return static_cast<float>(srgbOfLinear(std::clamp(x, 0.0F, 1.0F))); };
  return {channel(linear.x), channel(linear.y), channel(linear.z)};
}

float brightest(const glm::vec3& light) {
  return std::max({light.x, light.y, light.z});
}

/// Encodes the height map as linear grey with 16 bits per pixel.
std::vector<std::byte> heightPicture(const draw::SkinMaps& maps, const ImageText& text) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * maps.relief.size());
  for (const glm::vec4& texel : maps.relief) {
    const long height = std::lround(65535.0F * std::clamp(texel.w, 0.0F, 1.0F));
    bytes.push_back(static_cast<std::uint8_t>(height >> 8));
    bytes.push_back(static_cast<std::uint8_t>(height & 0xff));
  }
  return encodePng({maps.size, 1, 16, bytes, true}, text);
}

}  // namespace

std::vector<std::string> mapNames(const glm::vec3& glow) {
  std::vector<std::string> names = {"albedo", "normal", "height", "roughness", "occlusion"};
  if (brightest(glow) > 0) names.emplace_back("emission");
  return names;
}

std::vector<MapPicture> encodeMaps(const draw::SkinMaps& maps, const glm::vec3& glow,
                                   const ImageText& text) {
  std::vector<MapPicture> files;
  files.push_back({"albedo", picture(maps, maps.surface, text,
                                     [](const glm::vec4& t) { return encodedColor(glm::vec3(t)); })});
  files.push_back({"normal", picture(maps, maps.relief, text,
                                     [](const glm::vec4& t) { return 0.5F * glm::vec3(t) + 0.5F; })});
  files.push_back({"height", heightPicture(maps, text)});
  const auto last = [](const glm::vec4& t) { return glm::vec3(t.w); };
  files.push_back({"roughness", picture(maps, maps.surface, text, last)});
  files.push_back({"occlusion", picture(maps, maps.light, text, last)});
  if (const float max = brightest(glow); max > 0)
    files.push_back({"emission", picture(maps, maps.light, text, [max](const glm::vec4& t) {
                       return encodedColor(glm::vec3(t) / max);
                     })});
  return files;
}

}  // namespace simreel::frame
