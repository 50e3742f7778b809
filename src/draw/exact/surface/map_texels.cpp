#include "draw/exact/surface/map_texels.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "draw/surface/mip_levels.hpp"
#include "gl/limits.hpp"
#include "sim/grid/picture_file.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace simreel::draw {

namespace {

constexpr std::uint32_t perByte = 257;  // factor 65535 / 255, which converts a byte to units of 1/65535

/// Returns the next smaller level. If the level above has W texels along an axis and the new level has w,
/// texel j covers the interval from j / w to (j + 1) / w of the axis. Its overlap with texel i of the level
/// above is counted in units of 1 / (w W).
NumberLevel below(const NumberLevel& above) {
  const auto wide = static_cast<std::int64_t>(above.size.x);
  const auto high = static_cast<std::int64_t>(above.size.y);
  const std::int64_t width = std::max<std::int64_t>(wide / 2, 1);
  const std::int64_t height = std::max<std::int64_t>(high / 2, 1);
  NumberLevel level{{static_cast<int>(width), static_cast<int>(height)}, {}};
  level.rgba.resize(static_cast<std::size_t>(4 * width * height));
  const auto overlap = [](std::int64_t i, std::int64_t w, std::int64_t j, std::int64_t all) {
    return std::max<std::int64_t>(std::min((i + 1) * w, (j + 1) * all) - std::max(i * w, j * all), 0);
  };
  const std::int64_t total = wide * high;
  for (std::int64_t y = 0; y < height; ++y)
    for (std::int64_t x = 0; x < width; ++x) {
      std::array<std::int64_t, 4> sum{};
      for (std::int64_t row = y * high / height; row < high && row * height < (y + 1) * high; ++row)
        for (std::int64_t column = x * wide / width; column < wide && column * width < (x + 1) * wide;
             ++column) {
          const std::int64_t weight = overlap(row, height, y, high) * overlap(column, width, x, wide);
          const auto at = static_cast<std::size_t>(4 * (row * wide + column));
          for (std::size_t k = 0; k < 4; ++k) sum[k] += weight * above.rgba[at + k];
        }
      const auto at = static_cast<std::size_t>(4 * (y * width + x));
      for (std::size_t k = 0; k < 4; ++k)
        level.rgba[at + k] = static_cast<std::uint16_t>((sum[k] + total / 2) / total);
    }
  return level;
}

}  // namespace

std::vector<NumberLevel> numberLevels(glm::ivec2 size, const std::vector<std::uint8_t>& rgba) {
  NumberLevel first{size, {}};
  first.rgba.reserve(rgba.size());
  for (const std::uint8_t byte : rgba) first.rgba.push_back(static_cast<std::uint16_t>(perByte * byte));
  std::vector<NumberLevel> levels{std::move(first)};
  while (levels.back().size != glm::ivec2(1, 1)) levels.push_back(below(levels.back()));
  return levels;
}

glm::ivec4 MapTexels::add(glm::ivec2 size, const std::vector<std::uint8_t>& rgba, Holds holds) {
  const std::size_t first = texels_.size();
  int levels = 0;
  if (holds == Holds::numbers) {
    const std::vector<NumberLevel> all = numberLevels(size, rgba);
    levels = static_cast<int>(all.size());
    texels_.resize(first + all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      texels_[first + i] = {static_cast<std::uint32_t>(texels_.size()), 0};
      for (std::size_t at = 0; at < all[i].rgba.size(); at += 4) {
        const std::uint16_t* p = &all[i].rgba[at];
        texels_.push_back({p[0] | static_cast<std::uint32_t>(p[1]) << 16U,
                           p[2] | static_cast<std::uint32_t>(p[3]) << 16U});
      }
    }
  } else {
    const std::vector<MipLevel> all = mipLevels(size, rgba);
    levels = static_cast<int>(all.size()) + 1;
    texels_.resize(first + all.size() + 1);
    const auto append = [&](std::size_t level, std::span<const std::uint8_t> bytes) {
      texels_[first + level] = {static_cast<std::uint32_t>(texels_.size()), 0};
      for (std::size_t at = 0; at < bytes.size(); at += 4) {
        const auto light = [&](std::size_t k) { return std::uint32_t{linearOfSrgb(bytes[at + k])}; };
        texels_.push_back({light(0) | light(1) << 16U, light(2) | (perByte * bytes[at + 3]) << 16U});
      }
    };
    append(0, rgba);
    for (std::size_t i = 0; i < all.size(); ++i) append(i + 1, all[i].rgba);
  }
  const auto maximum = static_cast<std::size_t>(gl::limits().texelBufferTexels);
  if (texels_.size() > maximum)
    fail(ExitCode::device,
         "the maps of the materials need {} texels, but this device allows {} "
         "(GL_MAX_TEXTURE_BUFFER_SIZE); use smaller pictures as maps",
         texels_.size(), maximum);
  return {size, levels, static_cast<int>(first)};
}

glm::ivec4 MapTexels::place(const scene::Map& map, Holds holds) {
  if (map.empty()) return glm::ivec4(0);
  const std::string name =
      map.image ? fmt::format("image {}", static_cast<const void*>(map.image.get())) : map.file.string();
  auto found = places_.find({name, holds});
  if (found == places_.end()) {
    glm::ivec4 place(0);
    if (map.image) {
      place = add(map.image->size, map.image->rgba, holds);
    } else {
      const sim::Picture picture = sim::decodePicture(readFile(map.file, "texture"), map.file.string(),
                                                      "texture", gl::limits().textureSize);
      place = add(picture.size, picture.rgba, holds);
    }
    found = places_.emplace(std::pair(name, holds), place).first;
  }
  glm::ivec4 place = found->second;
  place.z |= static_cast<int>(map.wrapU) << 8 | static_cast<int>(map.wrapV) << 10;
  return place;
}

const gl::Texture& MapTexels::texels() {
  // Kernels that can read maps need a texture even if the materials have none.
  if (texels_.empty()) texels_.emplace_back();
  if (texels_.size() > uploaded_) {
    view_ = {};
    buffer_ = gl::Buffer::ofTexels<Texel>("maps of materials", texels_);
    view_ = gl::Texture::view("maps of materials", GL_RG32UI, buffer_, sizeof(Texel));
    uploaded_ = texels_.size();
  }
  return view_;
}

}  // namespace simreel::draw
