#include "draw/texture_store.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "gl/context.hpp"
#include "gl/limits.hpp"

#include <algorithm>
#include <memory>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#include <stb/stb_image.h>

namespace simreel::draw {

namespace {

gl::Texture readPicture(const std::filesystem::path& file) {
  const std::string bytes = readFile(file, "texture");
  int width = 0;
  int height = 0;
  int channels = 0;
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  const int most = gl::limits().textureSize;
  // The header first: a small file may promise a picture that takes all memory.
  if (stbi_info_from_memory(data, size, &width, &height, &channels) != 0 && std::max(width, height) > most)
    fail(ExitCode::device, "the texture {} is {}x{}, this device allows up to {}x{} (GL_MAX_TEXTURE_SIZE)",
         file.string(), width, height, most, most);
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> texels(
      stbi_load_from_memory(data, size, &width, &height, &channels, 4), &stbi_image_free);
  if (!texels)
    fail(ExitCode::inputOutput, "the texture {} is not a picture this program reads ({}); use PNG or JPEG",
         file.string(), stbi_failure_reason());
  gl::Texture texture = gl::Texture::image("texture " + file.string(), GL_SRGB8_ALPHA8, width, height, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, texels.get());
  glGenerateTextureMipmap(texture.name());
  // llvmpipe filters anisotropically in software: even 2 takes the flag from 15.9 to 11.6 frames/s.
  const float anisotropy = std::min(gl::limits().anisotropy, gl::softwareDriver() ? 1.0F : 8.0F);
  if (anisotropy > 1.0F) glTextureParameterf(texture.name(), GL_TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
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
