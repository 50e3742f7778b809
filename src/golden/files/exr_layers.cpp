// Reads the channels of OpenEXR files that are not part of the colour picture.
#include "golden/files/exr_layers.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/text.hpp"
#include "sim/light/exr_stream.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescription.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <exception>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

namespace simreel::golden {

namespace {

constexpr double valueLimit = 5e8;
/// max number of values per file byte; OpenEXR's compressions never reach it
constexpr double maxOfOneByte = 65536;

std::string hashOf(const std::vector<std::uint32_t>& values) {
  return hashHex(std::as_bytes(std::span(values)));
}

/// Reads the layers of one part of an OpenEXR file.
class PartLayers {
 public:
  PartLayers(std::string_view bytes, Imf::MultiPartInputFile& file, int part,
             std::vector<PictureLayer>& layers)
      : bytes_(bytes), file_(file), part_(part), header_(file.header(part)), layers_(layers) {
    if (file.parts() > 1 && part > 0)
      prefix_ = (header_.hasName() ? oneLine(header_.name()) : fmt::format("part {}", part + 1)) + ".";
  }

  void read() {
    if (header_.hasType() && header_.type() != Imf::SCANLINEIMAGE && header_.type() != Imf::TILEDIMAGE)
      return addContent("deep pixels", hashHex(bytes_));
    if (header_.hasTileDescription() && header_.tileDescription().mode != Imf::ONE_LEVEL)
      addContent("levels", hashHex(bytes_));
    chooseMattes();
    readChannels();
    const Imath::Box2i &data = header_.dataWindow(), &shown = header_.displayWindow();
    const bool beyond = data.min.x < shown.min.x || data.min.y < shown.min.y || data.max.x > shown.max.x ||
                        data.max.y > shown.max.y;
    std::string around;
    for (auto& [name, channel] : channels_) {
      if (beyond || channel.sampled) around += hashOf(channel.values);
      if (channel.sampled)
        addContent(name, hashOf(channel.values));
      else if (!makesPicture(name))
        layers_.push_back({prefix_ + oneLine(name), channel.kind, placed(channel.values), {}});
    }
    if (beyond) addContent("pixels outside of the display window", hashHex(around));
  }

 private:
  struct Channel {
    PictureLayer::Kind kind;
    bool sampled;
    std::vector<std::uint32_t> values;  ///< channel values in the data window
  };

  void addContent(const std::string& name, std::string hash) {
    layers_.push_back({prefix_ + oneLine(name), PictureLayer::Kind::content, {}, std::move(hash)});
  }

  /// True for channels that decodePicture() uses as colour or alpha.
  [[nodiscard]] bool makesPicture(const std::string& name) const {
    if (part_ > 0) return false;
    const bool colour = channels_.contains("R") || channels_.contains("G") || channels_.contains("B");
    return name == "A" || (colour ? name == "R" || name == "G" || name == "B" : name == "Y");
  }

  /// Collects the names of Cryptomattes. The channels .R and .B of a Cryptomatte hold identifiers.
  void chooseMattes() {
    for (auto attribute = header_.begin(); attribute != header_.end(); ++attribute) {
      const std::string name = attribute.name();
      if (!name.starts_with("cryptomatte/") || !name.ends_with("/name")) continue;
      if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute.attribute()))
        mattes_.insert(text->value());
    }
  }

  [[nodiscard]] bool identifies(const std::string& name) const {
    return (name.ends_with(".R") || name.ends_with(".B")) &&
           std::any_of(mattes_.begin(), mattes_.end(),
                       [&](const std::string& matte) { return name.starts_with(matte); });
  }

  void readChannels() {
    const Imath::Box2i& window = header_.dataWindow();
    const double width = double(window.max.x) - window.min.x + 1,
                 height = double(window.max.y) - window.min.y + 1;
    Imf::FrameBuffer buffer;
    double values = 0;
    for (auto at = header_.channels().begin(); at != header_.channels().end(); ++at) {
      const Imf::Channel& found = at.channel();
      values += width * height;
      if (width < 1 || height < 1 || values > valueLimit)
        throw std::runtime_error("more than 500 million values in its layers");
      if (values > maxOfOneByte * static_cast<double>(bytes_.size()))
        throw std::runtime_error("more values in its layers than its bytes can hold");
      const bool whole = found.type == Imf::UINT;
      Channel& channel = channels_[at.name()];
      channel = {whole || identifies(at.name()) ? PictureLayer::Kind::exact : PictureLayer::Kind::number,
                 found.xSampling != 1 || found.ySampling != 1,
                 std::vector<std::uint32_t>(static_cast<std::size_t>(width * height), 0)};
      buffer.insert(at.name(), Imf::Slice::Make(whole ? Imf::UINT : Imf::FLOAT, channel.values.data(),
                                                window, 4, 4 * static_cast<std::size_t>(width),
                                                found.xSampling, found.ySampling));
    }
    Imf::InputPart part(file_, part_);
    part.setFrameBuffer(buffer);
    part.readPixels(window.min.y, window.max.y);
  }

  /// Copies values from the data window to the display window. Pixels outside of the data window become 0.
  [[nodiscard]] std::vector<std::uint32_t> placed(const std::vector<std::uint32_t>& values) const {
    const Imath::Box2i &data = header_.dataWindow(), &shown = header_.displayWindow();
    if (data == shown) return values;
    const std::ptrdiff_t width = shown.max.x - shown.min.x + 1, from = data.max.x - data.min.x + 1;
    std::vector<std::uint32_t> made(static_cast<std::size_t>(width * (shown.max.y - shown.min.y + 1)), 0);
    const int left = std::max(data.min.x, shown.min.x), right = std::min(data.max.x, shown.max.x);
    for (int y = std::max(data.min.y, shown.min.y); left <= right && y <= std::min(data.max.y, shown.max.y);
         ++y)
      std::copy_n(values.begin() + (y - data.min.y) * from + (left - data.min.x), right - left + 1,
                  made.begin() + (y - shown.min.y) * width + (left - shown.min.x));
    return made;
  }

  std::string_view bytes_;
  Imf::MultiPartInputFile& file_;
  int part_;
  const Imf::Header& header_;
  std::vector<PictureLayer>& layers_;
  std::string prefix_;
  std::set<std::string> mattes_;
  std::map<std::string, Channel> channels_;
};

}  // namespace

float PictureLayer::number(std::size_t pixel) const {
  return std::bit_cast<float>(bits[pixel]);
}

double PictureLayer::difference(const PictureLayer& other, std::size_t pixel) const {
  constexpr double maximum = 255, hair = 1e-6;
  if (bits[pixel] == other.bits[pixel]) return 0;
  if (kind != Kind::number || other.kind != Kind::number) return maximum;
  const float a = number(pixel), b = other.number(pixel);
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  const double between = maximum * std::abs(double{a} - double{b});
  return std::isnan(between) ? maximum : std::clamp(between, hair, maximum);
}

std::vector<PictureLayer> readExrLayers(std::string_view bytes, const std::string& label) {
  sim::ExrStream stream(bytes);
  std::vector<PictureLayer> layers;
  try {
    Imf::MultiPartInputFile file(stream);
    for (int part = 0; part < file.parts(); ++part) PartLayers(bytes, file, part, layers).read();
  } catch (const std::exception& error) {
    fail(ExitCode::inputOutput, "{} cannot be decoded ({})", label, oneLine(error.what()));
  }
  std::sort(layers.begin(), layers.end(),
            [](const PictureLayer& a, const PictureLayer& b) { return a.name < b.name; });
  return layers;
}

}  // namespace simreel::golden
