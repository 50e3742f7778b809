// Tests small files and short scenes that expand to gigabytes. They must be refused before anything is
// decoded or built.
#include "base/file.hpp"
#include "scene/load.hpp"
#include "scene/scene.hpp"
#include "sim/fluid/plan.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/light/light_file.hpp"
#include "sim/text/letters/font.hpp"
#include "sim/world/list.hpp"
#include "sim/world/world.hpp"
#include "unit/help.hpp"
#include "unit/hostile/hostile.hpp"

#include <cstdint>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>

using namespace simreel;
using namespace simreel::test;

namespace {

/// These functions return the bytes of a number. low() returns the lowest byte first, and high() the
/// highest byte first.
std::string low(std::uint32_t value, int bytes = 4) {
  std::string all;
  for (int i = 0; i < bytes; ++i) all += static_cast<char>(value >> (8 * i));
  return all;
}
std::string high(std::uint32_t value, int bytes) {
  const std::string all = low(value, bytes);
  return {all.rbegin(), all.rend()};
}

std::string attribute(const std::string& name, const std::string& type, const std::string& value) {
  return name + '\0' + type + '\0' + low(static_cast<std::uint32_t>(value.size())) + value;
}

/// Returns an EXR header with the attributes `more`, followed by a few truncated pixels.
std::string exr(std::uint32_t shown, const std::string& more) {
  const auto window = [](std::uint32_t side) {
    return low(0) + low(0) + low(side - 1) + low(side / 2 - 1);
  };
  const std::string channel = low(2) + low(0) + low(1) + low(1);
  const std::string channels = 'R' + std::string(1, '\0') + channel + std::string(1, '\0');
  return low(20000630) + low(2) + attribute("channels", "chlist", channels) +
         attribute("compression", "compression", low(0, 1)) + attribute("dataWindow", "box2i", window(2)) +
         attribute("displayWindow", "box2i", window(shown)) +
         attribute("lineOrder", "lineOrder", low(0, 1)) +
         attribute("pixelAspectRatio", "float", low(0x3f800000)) +
         attribute("screenWindowCenter", "v2f", low(0) + low(0)) +
         attribute("screenWindowWidth", "float", low(0x3f800000)) + more + '\0' + std::string(64, '\0');
}

/// Returns a TrueType font in which each glyph consists of two copies of the next one, `depth` levels deep.
/// The letter H is the second glyph.
std::string doublingFont(unsigned depth) {
  std::string glyphs, places = high(0, 4);
  for (unsigned i = 0; i <= depth; ++i) {
    if (i < depth) {
      glyphs += high(0xffff, 2) + high(0, 2) + high(0, 2) + high(100, 2) + high(100, 2);
      glyphs += high(0x22, 2) + high(i + 1, 2) + high(0, 2) + high(0x02, 2) + high(i + 1, 2) + high(0, 2);
    } else {  // The innermost glyph is a triangle.
      glyphs +=
          high(1, 2) + high(0, 2) + high(0, 2) + high(100, 2) + high(100, 2) + high(2, 2) + high(0, 2);
      glyphs +=
          std::string("\x37\x37\x37", 3) + std::string("\x01\x64\x01", 3) + std::string("\x01\x01\x64", 3);
      glyphs += std::string(1, '\0');
    }
    places += high(static_cast<std::uint32_t>(glyphs.size()), 4);
  }
  const unsigned count = depth + 1;
  const std::string map = high(0, 2) + high(1, 2) + high(3, 2) + high(10, 2) + high(12, 4) + high(12, 2) +
                          high(0, 2) + high(28, 4) + high(0, 4) + high(1, 4) + high('H', 4) + high('H', 4) +
                          high(1, 4);
  const std::string head = high(0x10000, 4) + high(0x10000, 4) + high(0, 4) + high(0x5f0f3cf5, 4) +
                           high(0, 2) + high(1000, 2) + std::string(16, '\0') + high(0, 2) + high(0, 2) +
                           high(1000, 2) + high(1000, 2) + high(0, 2) + high(8, 2) + high(2, 2) +
                           high(1, 2) + high(0, 2);
  const std::string lines =
      high(0x10000, 4) + high(800, 2) + high(0xff38, 2) + std::string(26, '\0') + high(1, 2);
  const std::string wide = high(1000, 2) + std::string(2 * (count + 1), '\0');
  const std::string maximum = high(0x10000, 4) + high(count, 2) + std::string(8, '\xff') + high(2, 2) +
                              std::string(12, '\0') + std::string(4, '\xff');
  const std::pair<const char*, const std::string*> tables[] = {
      {"cmap", &map},  {"glyf", &glyphs}, {"head", &head},   {"hhea", &lines},
      {"hmtx", &wide}, {"loca", &places}, {"maxp", &maximum}};
  std::string font = high(0x10000, 4) + high(7, 2) + high(64, 2) + high(2, 2) + high(48, 2), rest;
  for (const auto& [name, table] : tables) {
    font += name + high(0, 4) + high(static_cast<std::uint32_t>(124 + rest.size()), 4) +
            high(static_cast<std::uint32_t>(table->size()), 4);
    rest += *table + std::string((4 - table->size() % 4) % 4, '\0');
  }
  return font + rest;
}

}  // namespace

TEST_CASE("an attribute of an EXR longer than its file is refused") {
  const std::string more = std::string("foo") + '\0' + "string" + '\0' + low(0x7fffffff) + "aaaa";
  checkHas(refusal([&] { static_cast<void>(sim::decodeExr(exr(2, more), "sky", "")); }),
           "an attribute of 2147483647 bytes");
}

TEST_CASE("an EXR whose display window is far larger than its pixels is refused") {
  checkHas(refusal([&] { static_cast<void>(sim::decodeExr(exr(8192, ""), "sky", "")); }),
           "a display window of 8192x4096 pixels, but only 2x1");
}

TEST_CASE("a 1-bit PNG of 16384x16384 pixels is refused by its size") {
  std::string png = std::string("\x89PNG\r\n\x1a\n", 8) + high(13, 4) + "IHDR" + high(16384, 4) +
                    high(16384, 4) + std::string("\1\0\0\0\0", 5) + high(0, 4) + high(40000, 4) + "IDAT" +
                    std::string(40000, '\0');
  checkHas(refusal([&] { static_cast<void>(sim::decodePicture(png, "bits.png", "texture", 16384)); }),
           "16384x16384 pixels is above the limit of 134217728");
}

TEST_CASE("a font with exponentially nested glyphs uses little memory") {
  const TemporaryFile small("two.ttf", doublingFont(3));
  CHECK(sim::Font(small.path()).glyph(U'H').outlines.size() == 4);
  const TemporaryFile file("double.ttf", doublingFont(60));
  checkHas(refusal([&] { static_cast<void>(sim::Font(file.path())); }), "the outline of U+0048 is damaged");
}

TEST_CASE("a cloth of four million vertices is refused at its resolution parameter") {
  checkHas(
      refusal([&] {
        static_cast<void>(scene::parseScene(
            R"({"version": 1, "objects": {"a": {"cloth": {"mesh": {"shape": "plane", "resolution": [2000, 2000]}}}}})",
            "cloth.json", {}, sim::kinds()));
      }),
      "2000x2000 are more than 250000 vertices");
}

TEST_CASE("planning a fluid of 268 million cells allocates no memory per cell") {
  sim::FluidParameters parameters;
  parameters.size = {16384, 16384};
  CHECK(refusal([&] { static_cast<void>(sim::FluidPlan(parameters, "ink", 1, 0.02)); }) ==
        "nothing was refused");
}

TEST_CASE("checking water of 67 million cells allocates no memory per cell and reports the size") {
  const auto pond = [](const std::string& size) {
    return scene::parseScene(R"({"version": 1, "objects": {"pond": {"water": {"size": )" + size +
                                 R"(, "level": 1, "floats": [{"shape": "box", "size": [1, 1, 1]}]}}}})",
                             "pond.json", {}, sim::kinds());
  };
  const scene::Scene large = pond("[8192, 8192]");
  CHECK(refusal([&] { CHECK(sim::findProblems(large).empty()); }) == "nothing was refused");
  const std::vector<std::string> warnings = sim::tooLargeForMany(large);
  REQUIRE(warnings.size() == 1);
  checkHas(warnings[0],
           "water \"pond\" needs 1073741824 bytes in one buffer, and software drivers allow 134217728");
  CHECK(sim::tooLargeForMany(pond("[64, 64]")).empty());
}

TEST_CASE("checking epidemics and wildfires of 268 million cells allocates no memory per cell") {
  for (const char* object : {R"("epidemic": {"size": [16384, 16384], "infected": 0.1})",
                             R"("wildfire": {"size": [16384, 16384], "strokes": [{"radius": 3}]})"}) {
    const scene::Scene large =
        scene::parseScene(std::string(R"({"version": 1, "objects": {"a": {)") + object + "}}}",
                          "spread.json", {}, sim::kinds());
    CHECK(refusal([&] { CHECK(sim::findProblems(large).empty()); }) == "nothing was refused");
    CHECK(sim::tooLargeForMany(large).size() == 1);
  }
}

TEST_CASE("checking a spring cloth of 268 million particles allocates no memory per particle") {
  const scene::Scene large = scene::parseScene(
      R"({"version": 1, "objects": {"a": {"cloth": {"size": [16384, 16384], "substeps": "auto"}}}})",
      "cloth.json", {}, sim::kinds());
  CHECK(refusal([&] { CHECK(sim::findProblems(large).empty()); }) == "nothing was refused");
  CHECK(sim::tooLargeForMany(large).size() == 1);
}
