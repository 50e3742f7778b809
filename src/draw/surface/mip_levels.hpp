#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// One level of a texture: RGBA, 8 bits each, x fastest; rgba.size() == 4 * size.x * size.y.
struct MipLevel {
  glm::ivec2 size{0, 0};
  std::vector<std::uint8_t> rgba;
};

/// The levels below a picture of sRGB colour and straight alpha, half as large each (rounded down), to 1x1.
/// A texel is the mean of the area it covers of the level above, in linear light, weighted by alpha; where
/// all of it is transparent, the plain mean. In integers only, so that the same bytes come out on every
/// machine: glGenerateTextureMipmap of Mesa's software driver depends on the processor's maker.
/// rgba.size() == 4 * size.x * size.y (an invariant); sides are at most 32768.
[[nodiscard]] std::vector<MipLevel> mipLevels(glm::ivec2 size, std::span<const std::uint8_t> rgba);

/// Linear light of an sRGB byte, in 1/65535.
[[nodiscard]] std::uint16_t linearOfSrgb(std::uint8_t byte);

}  // namespace simreel::draw
