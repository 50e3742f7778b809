#include "draw/exact/surface/texel_lists.hpp"

#include "draw/surface/mip_levels.hpp"
#include "gl/limits.hpp"
#include "sim/grid/picture_file.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace simreel::draw {

namespace {

using Words = std::array<std::uint32_t, 4>;

std::array<std::uint32_t, 2> lightAt(std::span<const std::uint8_t> rgba, std::size_t texel) {
  const auto light = [&](std::size_t channel) -> std::uint32_t {
    return linearOfSrgb(rgba[4 * texel + channel]);
  };
  return {light(0) | light(1) << 16U, light(2)};
}

void append(std::vector<Words>& words, glm::ivec2 size, std::span<const std::uint8_t> rgba) {
  const auto width = static_cast<std::size_t>(size.x);
  for (std::size_t y = 0; y < static_cast<std::size_t>(size.y); ++y)
    for (std::size_t x = 0; x < width; ++x) {
      const auto here = lightAt(rgba, y * width + x);
      const auto next = lightAt(rgba, y * width + (x + 1) % width);
      words.push_back({here[0], here[1], next[0], next[1]});
    }
}

TexelLists::List listOf(const std::filesystem::path& file) {
  const sim::Picture picture = sim::loadPicture(file, "texture", gl::limits().textureSize);
  const std::vector<MipLevel> levels = mipLevels(picture.size, picture.rgba);
  TexelLists::List list;
  list.size = picture.size;
  list.levels = static_cast<int>(levels.size()) + 1;
  std::vector<Words> words(levels.size() + 1);
  words.reserve(words.size() + picture.rgba.size() / 3);  // all mip levels together have 4/3 of the
                                                          // picture's texels
  words[0][0] = static_cast<std::uint32_t>(words.size());
  append(words, picture.size, picture.rgba);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    words[i + 1][0] = static_cast<std::uint32_t>(words.size());
    append(words, levels[i].size, levels[i].rgba);
  }
  list.texels = gl::Buffer::ofTexels<Words>("texels of " + file.string(), words);
  list.view = gl::Texture::view("texels of " + file.string(), GL_RGBA32UI, list.texels, sizeof(Words));
  return list;
}

}  // namespace

const TexelLists::List* TexelLists::load(const std::filesystem::path& file) {
  if (file.empty()) return nullptr;
  const auto found = lists_.find(file);
  if (found != lists_.end()) return &found->second;
  return &lists_.emplace(file, listOf(file)).first->second;
}

}  // namespace simreel::draw
