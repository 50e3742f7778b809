#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// One mip level in row-major order: RGBA, 8 bits each; rgba.size() == 4 * size.x * size.y.
struct MipLevel {
  glm::ivec2 size{0, 0};
  std::vector<std::uint8_t> rgba;
};

/// Returns the mip levels below a picture with sRGB colour and straight alpha. Each level has half the size
/// of the level above (rounded down), to 1x1. A texel is the alpha-weighted mean, in linear light, of the
/// area that it covers in the level above. If that area is fully transparent, the mean is unweighted. Uses
/// only integers, so the bytes are the same on every machine, whereas glGenerateTextureMipmap in Mesa's
/// software driver depends on the CPU vendor. Requires rgba.size() == 4 * size.x * size.y and sides of at
/// most 32768.
[[nodiscard]] std::vector<MipLevel> mipLevels(glm::ivec2 size, std::span<const std::uint8_t> rgba);

/// Returns the linear light of an sRGB byte, in units of 1/65535.
[[nodiscard]] std::uint16_t linearOfSrgb(std::uint8_t byte);

}  // namespace simreel::draw
