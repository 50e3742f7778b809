// Tests OpenEXR pictures of light. They are read back by the library and by the golden runner's reader.
#include "frame/exr.hpp"

#include "golden/files/picture.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <unistd.h>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

draw::PictureLayers smallLayers() {
  draw::PictureLayers made;
  made.size = {5, 3};
  made.alpha = true;
  for (int i = 0; i < 15; ++i)
    for (const float value : {0.125F * static_cast<float>(i), 3.0F, 1e6F, static_cast<float>(i) / 15})
      made.light.push_back(value);
  for (int i = 0; i < 15; ++i) made.depth.push_back(i == 4 ? std::numeric_limits<float>::infinity() : 2.5F);
  for (int i = 0; i < 45; ++i) made.position.push_back(static_cast<float>(i) - 7.25F);
  for (std::uint32_t i = 0; i < 15; ++i)
    made.primitive.push_back(i == 4 ? draw::PictureLayers::noPrimitive : 16777217 + i);
  made.objects = {"flag", "ground", "a ball"};
  made.ranks = 4;
  made.shares.resize(60);
  made.shares[0] = {1, 0.75F};
  made.shares[1] = {0, 0.25F};
  made.shares[58] = {2, 0.25F};
  return made;
}

struct WrittenFile {
  explicit WrittenFile(const std::vector<std::byte>& bytes)
      : path(std::filesystem::temp_directory_path() / ("simreel_exr_" + std::to_string(::getpid()))) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  ~WrittenFile() { std::filesystem::remove(path); }
  std::filesystem::path path;
};

std::vector<float> channelNamed(Imf::InputFile& file, const char* name) {
  std::vector<float> values(15);
  Imf::FrameBuffer frame;
  frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 20));
  file.setFrameBuffer(frame);
  file.readPixels(0, 2);
  return values;
}

}  // namespace

TEST_CASE("exr: colour, depth, position and object IDs are read back") {
  const draw::PictureLayers made = smallLayers();
  const WrittenFile written(frame::encodeExr(made, {{"simreel:frame", "7"}}));
  Imf::InputFile file(written.path.c_str());
  CHECK(file.header().typedAttribute<Imf::StringAttribute>("simreel:frame").value() == "7");
  CHECK(channelNamed(file, "R")[9] == 1.125F);
  CHECK(channelNamed(file, "B")[3] == 65504.0F);  // Values are clamped to the max half.
  CHECK(channelNamed(file, "A")[14] == doctest::Approx(14.0 / 15).epsilon(1e-3));
  CHECK(channelNamed(file, "Z")[3] == 2.5F);
  CHECK(std::isinf(channelNamed(file, "Z")[4]));
  CHECK(channelNamed(file, "P.Y")[2] == made.position[7]);
  std::vector<std::uint32_t> primitives(15);
  Imf::FrameBuffer frame;
  frame.insert("primitive", Imf::Slice(Imf::UINT, reinterpret_cast<char*>(primitives.data()), 4, 20));
  file.setFrameBuffer(frame);
  file.readPixels(0, 2);
  CHECK(file.header().channels().findChannel("primitive")->type == Imf::UINT);
  CHECK(primitives == made.primitive);
  const auto idOf = [](const char* name) { return std::bit_cast<float>(frame::cryptomatteId(name)); };
  CHECK(channelNamed(file, "CryptoObject00.R")[0] == idOf("ground"));
  CHECK(channelNamed(file, "CryptoObject00.G")[0] == 0.75F);
  CHECK(channelNamed(file, "CryptoObject00.B")[0] == idOf("flag"));
  CHECK(channelNamed(file, "CryptoObject00.A")[0] == 0.25F);
  CHECK(channelNamed(file, "CryptoObject01.R")[14] == idOf("a ball"));
  CHECK(channelNamed(file, "CryptoObject00.G")[7] == 0.0F);
  std::string manifest;
  for (auto i = file.header().begin(); i != file.header().end(); ++i) {
    const std::string name = i.name();
    if (!name.starts_with("cryptomatte/")) continue;
    CHECK(name.find('/', 12) == 12 + 7);
    if (name.ends_with("/manifest"))
      manifest = dynamic_cast<const Imf::StringAttribute&>(i.attribute()).value();
  }
  CHECK(manifest.starts_with(R"({"flag":")"));
  CHECK(manifest.find(R"("a ball":")") != std::string::npos);
}

TEST_CASE("exr: the golden runner reads the written files") {
  draw::PictureLayers made = smallLayers();
  made.alpha = false;
  const auto bytes = frame::encodeExr(made, {});
  const golden::Picture read = golden::decodePicture(
      {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, "picture", "x.exr");
  CHECK(read.depth == golden::Depth::linear);
  CHECK(read.image.width == 5);
  CHECK(read.image.height == 3);
}

TEST_CASE("exr: the hash covers every layer, and equal content gives equal files") {
  const draw::PictureLayers made = smallLayers();
  CHECK((frame::encodeExr(made, {}) == frame::encodeExr(made, {})));
  const std::string hash = frame::pixelHash(made);
  const auto differs = [&](auto change) {
    draw::PictureLayers other = made;
    change(other);
    return frame::pixelHash(other) != hash;
  };
  CHECK(frame::pixelHash(smallLayers()) == hash);
  CHECK(differs([](auto& p) { p.light[7] += 1e-3F; }));
  CHECK(differs([](auto& p) { p.alpha = false; }));
  CHECK(differs([](auto& p) { p.depth[3] = 2; }));
  CHECK(differs([](auto& p) { p.position[3] = 2; }));
  CHECK(differs([](auto& p) { p.primitive[4] = 3; }));
  CHECK(differs([](auto& p) { p.objects[1] = "floor"; }));
  CHECK(differs([](auto& p) { p.shares[58].coverage = 0.5F; }));
}

TEST_CASE("exr: object IDs are MurmurHash3 of the names") {
  // values from the reference implementation (SMHasher) with seed 0
  CHECK(frame::cryptomatteId("hello") == 0x248bfa47U);
  CHECK(frame::cryptomatteId("hello, world") == 0x149bbb7fU);
  CHECK(frame::cryptomatteId("The quick brown fox jumps over the lazy dog") == 0x2e4ff723U);
  CHECK(frame::cryptomatteId("") == 1U << 23);  // The hash 0 is changed, because 0 is not a normal float.
}
