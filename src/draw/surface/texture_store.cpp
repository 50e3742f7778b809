#include "draw/surface/texture_store.hpp"

#include "draw/surface/mip_levels.hpp"
#include "gl/limits.hpp"
#include "sim/grid/picture_file.hpp"

#include <cstdint>
#include <vector>

namespace simreel::draw {

namespace {

gl::Texture readPicture(const std::filesystem::path& file) {
  const sim::Picture picture = sim::loadPicture(file, "texture", gl::limits().textureSize);
  gl::Texture texture =
      gl::Texture::image("texture " + file.string(), GL_SRGB8_ALPHA8, picture.size.x, picture.size.y, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  GLint number = 0;
  const auto upload = [&](glm::ivec2 size, const std::vector<std::uint8_t>& rgba) {
    glTextureSubImage2D(texture.name(), number++, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE,
                        rgba.data());
  };
  upload(picture.size, picture.rgba);
  for (const MipLevel& level : mipLevels(picture.size, picture.rgba)) upload(level.size, level.rgba);
  return texture;
}

}  // namespace

const gl::Texture* TextureStore::load(const std::filesystem::path& file) {
  if (file.empty()) return nullptr;
  const auto found = textures_.find(file);
  if (found != textures_.end()) return &found->second;
  return &textures_.emplace(file, readPicture(file)).first->second;
}

}  // namespace simreel::draw
