// Tests the values of bytes in a Radiance image. Radiance's own writer truncates values, which the reader
// must take into account.
#include "base/error.hpp"
#include "sim/light/light_file.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;  // NOLINT

namespace {

/// Encodes light as in "Real Pixels": truncated mantissas below 256 with a common power of two.
std::string stored(double red, double green, double blue) {
  int exponent = 0;
  static_cast<void>(std::frexp(std::max({red, green, blue}), &exponent));
  std::string bytes;
  for (const double part : {red, green, blue})
    bytes += static_cast<char>(static_cast<unsigned char>(std::ldexp(part, 8 - exponent)));
  return bytes + static_cast<char>(exponent + 128);
}

sim::LightFile readBack(const std::string& pixels) {
  const std::string size = std::to_string(pixels.size() / 4);
  return sim::decodeRadiance("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X " + size + "\n" + pixels,
                             "a.hdr", "");
}

}  // namespace

TEST_CASE("Radiance: a mantissa is decoded to the middle of its quantization interval") {
  const sim::LightFile ones = readBack(stored(1, 1, 1) + stored(0.25, 0, 0.125));
  CHECK(ones.values[0] == 128.5F / 128);  // Byte 128 stands for 1.004, as in Radiance.
  CHECK(ones.values[4] == 0.25F * 128.5F / 128);
  CHECK(ones.values[5] == 0.25F * 0.5F / 128);
  CHECK(readBack(std::string("\x80\x80\x80\x00", 4)).values[0] == 0.0F);
  // The mean brightness must survive encoding. Without the added half, about 0.3 % would be lost.
  constexpr int count = 5000;
  std::string pixels;
  double light = 0, read = 0;
  for (int i = 0; i < count; ++i) {
    const double value = std::exp2(8.0 * (i + 0.5) / count - 4);
    light += value;
    pixels += stored(value, 0.7 * value, 0.2 * value);
  }
  const sim::LightFile found = readBack(pixels);
  for (std::size_t i = 0; i < count; ++i) read += static_cast<double>(found.values[4 * i]);
  CHECK(read == doctest::Approx(light).epsilon(2e-4).scale(0));
}

TEST_CASE("Radiance: old run lengths (before 1991) repeat pixels, consecutive runs with factors of 256") {
  const auto picture = [](const std::string& size, const std::string& pixels) {
    return sim::decodeRadiance("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n" + size + "\n" + pixels, "a.hdr",
                               "");
  };
  const std::string red("\x80\x01\x01\x81", 4), green("\x01\x80\x01\x81", 4);
  const auto run = [](int count) { return std::string("\1\1\1", 3) + static_cast<char>(count); };
  const sim::LightFile found =
      picture("-Y 2 +X 600", red + run(0x57) + run(2) + green + run(10) + red + run(0x4c) + run(2));
  REQUIRE(found.size == glm::ivec2(600, 2));
  for (std::size_t i = 0; i < 1200; ++i) {
    const bool isGreen = i >= 600 && i < 611;
    REQUIRE(found.values[4 * i] == (isGreen ? 1.5F / 128 : 128.5F / 128));
  }
  for (const std::string& pixels : {run(3) + red, red + run(16), red + run(1) + run(1) + run(1) + run(1)})
    CHECK_THROWS_WITH_AS(static_cast<void>(picture("-Y 1 +X 16", pixels)),
                         doctest::Contains("a run leaves its row"), UserError);
}

TEST_CASE("Radiance: headers may have Windows line ends, and other primaries are reported") {
  const auto picture = [](const std::string& more) {
    return sim::decodeRadiance("#?RADIANCE\r\n" + more + "FORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n" +
                                   std::string("\x80\x80\x80\x81", 4),
                               "a.hdr", "");
  };
  CHECK(picture("").values[0] == 128.5F / 128);
  CHECK(picture("").unfit.empty());
  for (const char* usual :
       {"0.64 0.33 0.29 0.60 0.15 0.06 0.333 0.333", "0.64 0.33 0.3 0.6 0.15 0.06 0.3127 0.329"})
    CHECK(picture(std::string("PRIMARIES= ") + usual + "\r\n").unfit.empty());
  CHECK(
      picture("PRIMARIES=0.708 0.292 0.17 0.797 0.131 0.046 0.3127 0.329\r\n").unfit ==
      "has primaries of its own (0.708 0.292 0.17 0.797 0.131 0.046 0.3127 0.329); convert it to those of "
      "Rec. 709 (sRGB)");
}
