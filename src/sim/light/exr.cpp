// Reads OpenEXR images with the OpenEXR library: scanlines and tiles, all compressions, and half, float and
// integer channels.
#include "base/error.hpp"
#include "base/text.hpp"
#include "sim/light/exr_stream.hpp"
#include "sim/light/light_file.hpp"

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfEnvmap.h>
#include <ImfEnvmapAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <exception>
#include <vector>

#include <fmt/ranges.h>

namespace simreel::sim {

namespace {

constexpr double maxPixels = 1e8;

struct Window {
  int left, top, width, height;
};

Window windowOf(const Imath::Box2i& box) {
  const auto side = [](int from, int to) {
    const long length = long{to} - from + 1;
    if (length < 1 || length > LightFile::largestSide)
      throw std::runtime_error(
          fmt::format("a window of {} pixels; 1 to {} are read", length, LightFile::largestSide));
    return static_cast<int>(length);
  };
  return {box.min.x, box.min.y, side(box.min.x, box.max.x), side(box.min.y, box.max.y)};
}

bool isRec709(const Imf::Chromaticities& named) {
  constexpr float rounding = 1e-3F;
  const Imf::Chromaticities usual;
  return named.red.equalWithAbsError(usual.red, rounding) &&
         named.green.equalWithAbsError(usual.green, rounding) &&
         named.blue.equalWithAbsError(usual.blue, rounding) &&
         named.white.equalWithAbsError(usual.white, rounding);
}

/// Names of the channels for R, G, B and A (null if missing), and names of the channels that are not used.
struct Chosen {
  std::vector<const char*> names;
  std::vector<std::string> others;
};

Chosen choose(const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  const bool colour = has("R") || has("G") || has("B");
  Chosen chosen;
  for (const char* name : {"R", "G", "B"}) {
    const char* source = colour ? name : "Y";
    chosen.names.push_back(has(source) ? source : nullptr);
  }
  chosen.names.push_back(has("A") ? "A" : nullptr);
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    const std::string name = channel.name();
    const bool used = std::any_of(chosen.names.begin(), chosen.names.end(),
                                  [&](const char* one) { return one != nullptr && name == one; });
    if (!used) chosen.others.push_back(oneLine(name));
  }
  if (std::all_of(chosen.names.begin(), chosen.names.end(),
                  [](const char* name) { return name == nullptr; }))
    throw std::runtime_error(
        fmt::format("no channel R, G, B, Y or A, only {}", fmt::join(chosen.others, ", ")));
  return chosen;
}

/// Throws if an attribute of a header is longer than the rest of the file, because the library would first
/// allocate memory for it. A header is a list of names, types and lengths and ends with an empty name. In a
/// multi-part file, a second empty name ends the list of headers.
void checkAttributes(std::string_view bytes, bool severalParts) {
  std::size_t at = 8;  // the headers start after the magic number, version and flags
  const auto word = [&] {
    const std::size_t end = bytes.find('\0', at);
    const bool none = end == std::string_view::npos;
    const std::string_view text = none ? std::string_view() : bytes.substr(at, end - at);
    at = none ? bytes.size() : end + 1;
    return text;
  };
  for (bool ended = false; at < bytes.size();) {
    if (word().empty()) {
      if (ended || !severalParts) return;
      ended = true;
      continue;
    }
    ended = false;
    static_cast<void>(word());  // skips the type
    if (bytes.size() - at < 4) return;
    std::uint32_t length = 0;
    for (std::size_t i = 4; i-- > 0;) length = length << 8U | static_cast<unsigned char>(bytes[at + i]);
    at += 4;
    if (length > bytes.size() - at)
      throw std::runtime_error(
          fmt::format("an attribute of {} bytes, where {} are left", length, bytes.size() - at));
    at += length;
  }
}

/// Reads the chosen channels of the data window as RGBA, row by row. A grey image has equal R, G and B. A
/// missing alpha is 1.
std::vector<float> readPixels(Imf::MultiPartInputFile& file, const Chosen& chosen, const Window& data) {
  const Imf::Header& header = file.header(0);
  Imf::InputPart part(file, 0);
  std::vector<float> pixels(4 * std::size_t(data.width) * std::size_t(data.height), 0.0F);
  Imf::FrameBuffer buffer;
  // A frame buffer accepts each channel name only once, so for a grey image Y is read into one slice and
  // copied below.
  for (std::size_t c = 0; c < 4; ++c) {
    const char* name = chosen.names[c];
    if (name == nullptr || buffer.findSlice(name) != nullptr) continue;
    if (header.channels().findChannel(name)->xSampling != 1 ||
        header.channels().findChannel(name)->ySampling != 1)
      throw std::runtime_error(fmt::format("a subsampled channel {}", name));
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, pixels.data() + c, header.dataWindow(), 16,
                                         16 * std::size_t(data.width)));
  }
  part.setFrameBuffer(buffer);
  part.readPixels(data.top, data.top + data.height - 1);
  const bool grey = chosen.names[0] != nullptr && std::string_view(chosen.names[0]) == "Y";
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    if (grey) pixels[i + 1] = pixels[i + 2] = pixels[i];
    if (chosen.names[3] == nullptr) pixels[i + 3] = 1;
  }
  return pixels;
}

/// Throws if a window is too large, or if the data window is far too small for the display window.
void checkSizes(const Window& data, const Window& shown) {
  if (double(data.width) * data.height > maxPixels || double(shown.width) * shown.height > maxPixels)
    throw std::runtime_error("more than 100 million pixels");
  constexpr double minShare = 1.0 / 64, smallArea = 1e6;
  if (double(shown.width) * shown.height > smallArea &&
      double(data.width) * data.height < minShare * shown.width * shown.height)
    throw std::runtime_error(fmt::format("a display window of {}x{} pixels, but only {}x{} pixels of data",
                                         shown.width, shown.height, data.width, data.height));
}

LightFile read(ExrStream& stream) {
  Imf::MultiPartInputFile file(stream);
  const Imf::Header& header = file.header(0);
  if (header.hasType() && header.type() != Imf::SCANLINEIMAGE && header.type() != Imf::TILEDIMAGE)
    throw std::runtime_error("deep pixels, which are not read");
  const Window data = windowOf(header.dataWindow()), shown = windowOf(header.displayWindow());
  checkSizes(data, shown);
  const Chosen chosen = choose(header.channels());
  const std::vector<float> pixels = readPixels(file, chosen, data);
  LightFile picture;
  picture.size = {shown.width, shown.height};
  picture.values.assign(4 * std::size_t(shown.width) * std::size_t(shown.height), 0.0F);
  for (int y = std::max(data.top, shown.top);
       y < std::min(data.top + data.height, shown.top + shown.height); ++y) {
    const int left = std::max(data.left, shown.left);
    const int right = std::min(data.left + data.width, shown.left + shown.width);
    if (left >= right) break;
    const auto from = 4 * (std::ptrdiff_t{y - data.top} * data.width + (left - data.left));
    const auto to = 4 * (std::ptrdiff_t{y - shown.top} * shown.width + (left - shown.left));
    std::copy_n(pixels.begin() + from, std::ptrdiff_t{4} * (right - left), picture.values.begin() + to);
  }
  if (const auto* named = header.findTypedAttribute<Imf::ChromaticitiesAttribute>("chromaticities"))
    if (!isRec709(named->value()))
      picture.colours =
          fmt::format("primaries of its own (red {:.3f} {:.3f}, green {:.3f} {:.3f})", named->value().red.x,
                      named->value().red.y, named->value().green.x, named->value().green.y);
  if (const auto* around = header.findTypedAttribute<Imf::EnvmapAttribute>("envmap");
      around != nullptr && around->value() == Imf::ENVMAP_CUBE)
    picture.unfit = "says that it is a cube map; convert it to one of latitude and longitude";
  for (std::size_t c = 0; c < 3; ++c)
    if (chosen.names[c] == nullptr)
      picture.unfit = fmt::format("has no channel {}", std::string_view("RGB").substr(c, 1));
  std::vector<std::string> notes;
  if (!chosen.others.empty()) notes.push_back(fmt::format("channels {}", fmt::join(chosen.others, ", ")));
  if (file.parts() > 1) notes.push_back(fmt::format("parts 2 to {}", file.parts()));
  if (data.left < shown.left || data.top < shown.top || data.left + data.width > shown.left + shown.width ||
      data.top + data.height > shown.top + shown.height)
    notes.emplace_back("pixels outside of the display window");
  picture.note = fmt::format("{}", fmt::join(notes, "; "));
  return picture;
}

}  // namespace

bool isExr(std::string_view bytes) {
  return bytes.starts_with("\x76\x2f\x31\x01");
}

LightFile decodeExr(std::string_view bytes, const std::string& label, const std::string& advice) {
  ExrStream stream(bytes);
  constexpr unsigned char multipart = 0x10;  // flag in the second byte of the version field
  try {
    checkAttributes(bytes, bytes.size() > 5 && (static_cast<unsigned char>(bytes[5]) & multipart) != 0);
    return read(stream);
  } catch (const std::exception& error) {
    if (stream.beyond())
      fail(ExitCode::inputOutput, "{} is cut off after {} bytes; {}", label, bytes.size(), advice);
    fail(ExitCode::inputOutput, "{} cannot be decoded ({})", label, oneLine(error.what()));
  }
}

}  // namespace simreel::sim
