#include "draw/surface/texture_store.hpp"

#include "draw/surface/mip_levels.hpp"
#include "frame/image.hpp"
#include "gpu/context.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <epoxy/gl.h>

using namespace simreel;

TEST_CASE("textures of files have the mip levels that we compute") {
  testContext();
  frame::Image picture{37, 22, {}};
  for (int i = 0; i < 37 * 22; ++i)
    for (const int channel : {7 * i, 31 * i, i * i, 255})
      picture.bytes.push_back(static_cast<std::uint8_t>(channel));
  const auto png = frame::encodePng(picture, {});
  const test::TemporaryFile file("texture.png",
                                 std::string(reinterpret_cast<const char*>(png.data()), png.size()));
  draw::TextureStore store;
  const gl::Texture* texture = store.load(file.path());
  REQUIRE(texture != nullptr);
  std::vector<draw::MipLevel> expected = draw::mipLevels({37, 22}, picture.bytes);
  expected.insert(expected.begin(), {{37, 22}, picture.bytes});
  REQUIRE(expected.size() == 6);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    std::vector<std::uint8_t> found(expected[i].rgba.size());
    glGetTextureImage(texture->name(), static_cast<GLint>(i), GL_RGBA, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(found.size()), found.data());
    CHECK_MESSAGE(found == expected[i].rgba, "level ", i);
  }
}
