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

/// All maps of the materials of a scene as one list of texels (glsl/draw/exact/surface/map_read.glsl). Each
/// picture is read once. Row 0 of it is v = 0.
class MapTexels {
 public:
  enum class Holds { color, numbers };  ///< sRGB, which becomes linear light; or numbers 0 to 1
  /// Width, height, how many levels it has (negative: its border goes on), and where those begin: a word a
  /// level, then texels of 16 bits a channel. Of no map 0. Throws UserError as loadPicture() does, but for
  /// transparent pixels; device where all of them are more than the device holds.
  glm::ivec4 place(const scene::Map& map, Holds holds);
  /// All that have been placed, RG32UI.
  [[nodiscard]] const gl::Texture& texels();

 private:
  using Texel = std::array<std::uint32_t, 2>;  ///< r + 2^16 g, b + 2^16 a
  glm::ivec4 add(glm::ivec2 size, const std::vector<std::uint8_t>& rgba, Holds holds);

  std::map<std::pair<std::string, Holds>, glm::ivec4> places_;
  std::vector<Texel> texels_;
  std::size_t uploaded_ = 0;
  gl::Buffer buffer_;
  gl::Texture view_;
};

/// A picture's levels as numbers: each texel is the mean of what it covers of the picture, in 1/65535, four
/// channels; from the picture itself down to one texel.
struct NumberLevel {
  glm::ivec2 size{0, 0};
  std::vector<std::uint16_t> rgba;
};
[[nodiscard]] std::vector<NumberLevel> numberLevels(glm::ivec2 size, const std::vector<std::uint8_t>& rgba);

}  // namespace simreel::draw
