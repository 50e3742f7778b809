#include "draw/surface/texture_store.hpp"

#include "base/hash.hpp"
#include "draw/surface/mip_levels.hpp"
#include "draw/surface/number_mips.hpp"
#include "frame/image.hpp"
#include "gpu/context.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <epoxy/gl.h>

using namespace simreel;

namespace {

/// Returns texel i of the next smaller mip level of the row `values`, in double precision. For odd sizes, a
/// texel is a weighted mean of three texels.
double meanOf(const std::vector<double>& values, int i) {
  const auto count = static_cast<int>(values.size());
  if (count == 1) return values[0];
  const int n = count / 2;
  const auto at = static_cast<std::size_t>(2 * i);
  if (count % 2 == 0) return (values[at] + values[at + 1]) / 2;
  return (values[at] * (n - i) + values[at + 1] * n + values[at + 2] * (i + 1)) / count;
}

}  // namespace

TEST_CASE("file textures have the mip levels computed on the CPU") {
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

TEST_CASE("float textures have the mip levels of the reference filter, also at odd sizes") {
  testContext();
  std::string hashes;
  for (const auto& [width, height] : {std::pair{37, 22}, {1, 9}, {16, 16}}) {
    CAPTURE(width);
    const gl::Texture texture = gl::Texture::image("numbers", GL_RGBA16F, width, height, 0);
    std::vector<float> above;
    for (int i = 0; i < 4 * width * height; ++i)
      // The values are exactly representable as half floats.
      above.push_back(static_cast<float>((i * 7919) % 2003 - 900) / 512.0F);
    glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGBA, GL_FLOAT, above.data());
    draw::NumberMips mips;
    mips.make(texture, GL_RGBA16F);
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    int w = width;
    int h = height;
    for (int level = 1; w * h > 1; ++level) {
      CAPTURE(level);
      const int halfW = std::max(w / 2, 1);
      const int halfH = std::max(h / 2, 1);
      std::vector<float> found(static_cast<std::size_t>(4 * halfW * halfH));
      glGetTextureImage(texture.name(), level, GL_RGBA, GL_FLOAT,
                        static_cast<GLsizei>(found.size() * sizeof(float)), found.data());
      double worst = 0;
      for (int y = 0; y < halfH; ++y)
        for (int x = 0; x < halfW; ++x)
          for (int c = 0; c < 4; ++c) {
            std::vector<double> rows;
            for (int row = 0; row < h; ++row) {
              std::vector<double> texels;
              for (int column = 0; column < w; ++column)
                texels.push_back(
                    static_cast<double>(above[static_cast<std::size_t>(4 * (row * w + column) + c)]));
              rows.push_back(meanOf(texels, x));
            }
            const double wanted = meanOf(rows, y);
            const auto got = static_cast<double>(found[static_cast<std::size_t>(4 * (y * halfW + x) + c)]);
            worst = std::max(worst, std::abs(got - wanted) / (std::abs(wanted) + 0.125));
          }
      // The bound is half a unit in the last place of half floats (1/2048), with a small margin.
      CHECK(worst < 1.0 / 2040);
      hashes += hashHex(std::as_bytes(std::span(found)));
      above = found;
      w = halfW;
      h = halfH;
    }
  }
  CHECK(hashHex(hashes) == "881af7c09f01a1cc56b3c1252470ce1d");
}
