#pragma once
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "scene/finish.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::draw {

/// Stores all maps of a scene's materials in one list of texels (glsl/draw/exact/surface/map_read.glsl).
/// Each image file is read once. Row 0 of the file is at v = 0.
class MapTexels {
 public:
  /// Content of a map. color: sRGB, which is converted to linear light. numbers: values from 0 to 1, which
  /// are stored unchanged.
  enum class Holds { color, numbers };
  /// Adds a map to the list unless it is already there. Returns the map's width, height, number of mip
  /// levels (negative: the map is clamped at the border instead of repeated) and start index in the list.
  /// From there, the list holds one word per level with the level's start, then texels with 16 bits per
  /// channel. Returns 0 if the map is empty. Throws UserError as loadPicture() does, except that
  /// transparent pixels are allowed, and UserError(device) if all maps together exceed the device's limit.
  glm::ivec4 place(const scene::Map& map, Holds holds);
  /// Returns the texels of all added maps, RG32UI. Without a map, it is one texel.
  [[nodiscard]] const gl::Texture& texels();

 private:
  using Texel = std::array<std::uint32_t, 2>;  ///< two words: r + 2^16 g, then b + 2^16 a
  glm::ivec4 add(glm::ivec2 size, const std::vector<std::uint8_t>& rgba, Holds holds);

  std::map<std::pair<std::string, Holds>, glm::ivec4> places_;
  std::vector<Texel> texels_;
  std::size_t uploaded_ = 0;
  gl::Buffer buffer_;
  gl::Texture view_;
};

/// One mip level with four channels, in units of 1/65535. Each texel is the exact mean of the image area
/// that it covers. numberLevels() returns all levels from the full image down to one texel.
struct NumberLevel {
  glm::ivec2 size{0, 0};
  std::vector<std::uint16_t> rgba;
};
[[nodiscard]] std::vector<NumberLevel> numberLevels(glm::ivec2 size, const std::vector<std::uint8_t>& rgba);

}  // namespace simreel::draw
