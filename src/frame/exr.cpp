// OpenEXR encoding with the OpenEXR library.
#include "frame/exr.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <algorithm>
#include <bit>
#include <cstring>
#include <deque>
#include <exception>
#include <new>
#include <span>
#include <utility>

#include <fmt/format.h>

namespace simreel::frame {

namespace {

using draw::PictureLayers;
constexpr const char* matteName = "CryptoObject";

class MemoryStream final : public Imf::OStream {
 public:
  MemoryStream() : OStream("picture") {}
  void write(const char from[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (at_ + size > bytes_.size()) bytes_.resize(at_ + size);
    std::memcpy(bytes_.data() + at_, from, size);
    at_ += size;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = position; }
  [[nodiscard]] std::vector<std::byte> release() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
};

/// Owns the channel values until the file is written.
class Channels {
 public:
  explicit Channels(glm::ivec2 size)
      : width_(static_cast<std::size_t>(size.x)), height_(static_cast<std::size_t>(size.y)) {}

  /// Adds a channel made of every `stride`-th float, starting at the first.
  void add(Imf::Header& header, const std::string& name, const float* values, std::size_t stride,
           Imf::PixelType type) {
    header.channels().insert(name.c_str(), Imf::Channel(type));
    std::vector<float>& kept = values_.emplace_back(width_ * height_);
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = values[i * stride];
    if (type == Imf::HALF) {
      std::vector<half>& halves = halves_.emplace_back(kept.size());
      std::transform(kept.begin(), kept.end(), halves.begin(), asHalf);
      return insert(name, type, halves.data());
    }
    insert(name, type, kept.data());
  }
  /// Adds a channel of 32-bit unsigned integers.
  void add(Imf::Header& header, const std::string& name, const std::vector<std::uint32_t>& numbers) {
    header.channels().insert(name.c_str(), Imf::Channel(Imf::UINT));
    std::vector<std::uint32_t>& kept = numbers_.emplace_back(numbers);
    insert(name, Imf::UINT, kept.data());
  }
  [[nodiscard]] const Imf::FrameBuffer& frame() const { return frame_; }

 private:
  /// Converts to half. Values above the largest finite half become the largest finite half, so that no
  /// value becomes infinite.
  static half asHalf(float value) { return half(std::min(value, 65504.0F)); }

  template <class Value>
  void insert(const std::string& name, Imf::PixelType type, Value* first) {
    frame_.insert(name.c_str(),
                  Imf::Slice(type, reinterpret_cast<char*>(first), sizeof(Value), sizeof(Value) * width_));
  }

  std::size_t width_, height_;
  std::deque<std::vector<float>> values_;
  std::deque<std::vector<half>> halves_;
  std::deque<std::vector<std::uint32_t>> numbers_;
  Imf::FrameBuffer frame_;
};

std::string manifestOf(const std::vector<std::string>& objects) {
  std::string manifest = "{";
  for (const std::string& name : objects)
    manifest +=
        fmt::format("{}\"{}\":\"{:08x}\"", manifest.size() > 1 ? "," : "", name, cryptomatteId(name));
  return manifest + "}";
}

void addMatte(Imf::Header& header, Channels& channels, const PictureLayers& picture) {
  const std::string key = fmt::format("cryptomatte/{:08x}", cryptomatteId(matteName)).substr(0, 12 + 7);
  header.insert(key + "/name", Imf::StringAttribute(matteName));
  header.insert(key + "/hash", Imf::StringAttribute("MurmurHash3_32"));
  header.insert(key + "/conversion", Imf::StringAttribute("uint32_to_float32"));
  header.insert(key + "/manifest", Imf::StringAttribute(manifestOf(picture.objects)));
  std::vector<float> ids;
  for (const std::string& name : picture.objects) ids.push_back(std::bit_cast<float>(cryptomatteId(name)));
  const auto ranks = static_cast<std::size_t>(picture.ranks);
  const std::size_t pixels = picture.shares.size() / ranks;
  for (std::size_t rank = 0; rank < ranks; rank += 2) {
    std::vector<float> values(4 * pixels);
    for (std::size_t i = 0; i < pixels; ++i)
      for (std::size_t k = 0; k < 2 && rank + k < ranks; ++k) {
        const PictureLayers::ObjectCoverage& share = picture.shares[i * ranks + rank + k];
        if (share.coverage <= 0) continue;
        values[4 * i + 2 * k] = ids[share.object];
        values[4 * i + 2 * k + 1] = share.coverage;
      }
    for (std::size_t c = 0; c < 4; ++c)
      channels.add(header, fmt::format("{}{:02}.{}", matteName, rank / 2, "RGBA"[c]), values.data() + c, 4,
                   Imf::FLOAT);
  }
}

/// Appends the name and hash of `values` to `all`, the text that is hashed.
template <class Value>
void addTo(std::string& all, const char* what, const std::vector<Value>& values) {
  if (!values.empty()) all += fmt::format(" {} {}", what, hashHex(std::as_bytes(std::span(values))));
}

}  // namespace

std::vector<std::byte> encodeExr(const PictureLayers& picture, const ImageText& text) {
  const glm::ivec2 size = picture.size;
  SIMREEL_CHECK_EQ(picture.light.size(),
                   4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  Imf::Header header(size.x, size.y);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.insert("chromaticities", Imf::ChromaticitiesAttribute(Imf::Chromaticities()));
  for (const auto& [keyword, value] : text) header.insert(keyword, Imf::StringAttribute(value));
  Channels channels(size);
  for (std::size_t c = 0; c < (picture.alpha ? 4 : 3); ++c)
    channels.add(header, std::string(1, "RGBA"[c]), picture.light.data() + c, 4,
                 picture.bits == 32 ? Imf::FLOAT : Imf::HALF);
  if (!picture.depth.empty()) channels.add(header, "Z", picture.depth.data(), 1, Imf::FLOAT);
  if (!picture.position.empty())
    for (std::size_t c = 0; c < 3; ++c)
      channels.add(header, fmt::format("P.{}", "XYZ"[c]), picture.position.data() + c, 3, Imf::FLOAT);
  for (std::size_t c = 0; c < 2 && !picture.vector.empty(); ++c)
    channels.add(header, fmt::format("vector.{}", "XY"[c]), picture.vector.data() + c, 2, Imf::FLOAT);
  for (std::size_t c = 0; c < 3; ++c) {
    if (!picture.velocity.empty())
      channels.add(header, fmt::format("velocity.{}", "XYZ"[c]), picture.velocity.data() + c, 3,
                   Imf::FLOAT);
    if (!picture.normal.empty())
      channels.add(header, fmt::format("N.{}", "XYZ"[c]), picture.normal.data() + c, 3, Imf::FLOAT);
    if (!picture.albedo.empty())
      channels.add(header, fmt::format("albedo.{}", "RGB"[c]), picture.albedo.data() + c, 3, Imf::HALF);
  }
  for (std::size_t c = 0; c < 2 && !picture.uv.empty(); ++c)
    channels.add(header, fmt::format("uv.{}", "UV"[c]), picture.uv.data() + c, 2, Imf::FLOAT);
  if (!picture.primitive.empty()) channels.add(header, "primitive", picture.primitive);
  if (!picture.shares.empty()) addMatte(header, channels, picture);
  MemoryStream stream;
  try {
    Imf::OutputFile file(stream, header, 1);
    file.setFrameBuffer(channels.frame());
    file.writePixels(size.y);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    fail(ExitCode::inputOutput, "cannot encode a {}x{} OpenEXR picture: {}", size.x, size.y, error.what());
  }
  return stream.release();
}

std::vector<std::byte> encodeDeepPng(const PictureLayers& picture, const ImageText& text) {
  SIMREEL_CHECK(picture.filmed);
  const std::size_t channels = picture.alpha ? 4 : 3;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(picture.light.size() / 4 * channels * 2);
  for (std::size_t i = 0; i < picture.light.size(); ++i) {
    if (i % 4 >= channels) continue;
    const float scaled = std::min(std::max(picture.light[i], 0.0F), 1.0F) * 65535.0F + 0.5F;
    const auto number = static_cast<std::uint32_t>(scaled);
    bytes.push_back(static_cast<std::uint8_t>(number >> 8U));
    bytes.push_back(static_cast<std::uint8_t>(number & 0xffU));
  }
  return encodePng({picture.size, static_cast<int>(channels), 16, bytes}, text);
}

std::string pixelHash(const PictureLayers& picture) {
  std::string all = fmt::format("{}x{}{}{}", picture.size.x, picture.size.y, picture.alpha ? " alpha" : "",
                                picture.filmed ? " filmed" : "");
  addTo(all, "light", picture.light);
  addTo(all, "depth", picture.depth);
  addTo(all, "position", picture.position);
  addTo(all, "normal", picture.normal);
  addTo(all, "albedo", picture.albedo);
  addTo(all, "uv", picture.uv);
  addTo(all, "velocity", picture.velocity);
  addTo(all, "vector", picture.vector);
  addTo(all, "primitive", picture.primitive);
  for (const std::string& object : picture.objects) all += " " + object;
  std::vector<float> shares;
  for (const PictureLayers::ObjectCoverage& share : picture.shares) {
    shares.push_back(static_cast<float>(share.object));
    shares.push_back(share.coverage);
  }
  addTo(all, "objects", shares);
  return hashHex(all);
}

// Implements MurmurHash3_x86_32 by Austin Appleby: mixes in 4-byte words one by one, then the remaining
// bytes, then the length.
std::uint32_t cryptomatteId(const std::string& name) {
  const auto mixed = [](std::uint32_t word) { return std::rotl(word * 0xcc9e2d51U, 15) * 0x1b873593U; };
  std::uint32_t hash = 0;
  std::size_t i = 0;
  for (; i + 4 <= name.size(); i += 4) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
      word |= std::uint32_t{static_cast<unsigned char>(name[i + k])} << (8 * k);
    hash = std::rotl(hash ^ mixed(word), 13) * 5 + 0xe6546b64U;
  }
  std::uint32_t rest = 0;
  for (std::size_t k = 0; i + k < name.size(); ++k)
    rest |= std::uint32_t{static_cast<unsigned char>(name[i + k])} << (8 * k);
  hash ^= mixed(rest);
  hash ^= static_cast<std::uint32_t>(name.size());
  hash = (hash ^ (hash >> 16)) * 0x85ebca6bU;
  hash = (hash ^ (hash >> 13)) * 0xc2b2ae35U;
  hash ^= hash >> 16;
  const std::uint32_t exponent = (hash >> 23) & 0xffU;
  return exponent == 0 || exponent == 255 ? hash ^ (1U << 23) : hash;
}

}  // namespace simreel::frame
