// Reader of Radiance HDR images (G. Ward, "Real Pixels", Graphics Gems II; ray/src/common/color.c): a text
// header, followed by run-length encoded pixels with one byte of mantissa for each of R, G and B and a
// common exponent.
#include "base/error.hpp"
#include "base/text.hpp"
#include "sim/light/light_file.hpp"
#include "sim/polygons/words.hpp"

#include <array>
#include <cmath>
#include <optional>

namespace simreel::sim {

namespace {

class RadianceFile {
 public:
  RadianceFile(std::string_view bytes, const std::string& label, const std::string& advice)
      : label_(label), advice_(advice), whole_(bytes.size()), rest_(bytes) {}

  LightFile read() {
    readHeader();
    std::string scanline(4 * std::size_t(width_), '\0');
    for (int y = 0; y < height_; ++y) {
      readScanline(scanline);
      picture_.values.resize(4 * std::size_t(width_) * std::size_t(y + 1));
      for (int x = 0; x < width_; ++x) setPixel(x, y, scanline);
    }
    picture_.size = {width_, height_};
    return std::move(picture_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    fail(ExitCode::inputOutput, "{} {}", label_, why);
  }
  [[noreturn]] void cutOff() const {
    refuse(fmt::format("is cut off after {} bytes; {}", whole_, advice_));
  }

  std::string_view line() {
    const std::size_t end = rest_.find('\n');
    if (end == std::string_view::npos) cutOff();
    std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    if (found.ends_with('\r')) found.remove_suffix(1);  // some headers have Windows line endings
    return found;
  }

  void readHeader() {
    static_cast<void>(line());  // skips the line #?RADIANCE or #?RGBE
    for (std::string_view text = line(); !text.empty(); text = line()) {
      if (text.starts_with("FORMAT=") && text != "FORMAT=32-bit_rle_rgbe")
        refuse(fmt::format("has the format {}, and only 32-bit_rle_rgbe is read", oneLine(text.substr(7))));
      if (constexpr std::string_view key = "PRIMARIES="; text.starts_with(key))
        checkPrimaries(text.substr(key.size()));
    }
    std::string_view size = line();
    const std::string shown = oneLine(size.substr(0, 40));
    const auto number = [&](std::string_view before) {
      if (!size.starts_with(before))
        refuse(fmt::format("has its rows in another order ({}), and only -Y ... +X ... is read", shown));
      size.remove_prefix(before.size());
      const auto found = takeInteger(size);
      if (!found || *found < 1 || *found > LightFile::largestSide)
        refuse(fmt::format("has no size from 1 to {} ({})", LightFile::largestSide, shown));
      return *found;
    };
    height_ = number("-Y ");
    width_ = number(" +X ");
    // Rejects sizes that are too large for the number of bytes. A run of 255 pixels takes four bytes; in
    // the newer format, a run of 127 pixels takes two bytes in each of four planes.
    if (double(width_) * height_ > double(rest_.size()) * 255 / 4 + 255) cutOff();
  }

  /// Accepts primaries that are close to Rec. 709. The default primaries of Radiance (green 0.29 0.6,
  /// equal-energy white) differ slightly, but the programs that write these primaries store Rec. 709
  /// colours.
  void checkPrimaries(std::string_view numbers) {
    constexpr std::array<double, 8> usual = {0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329};
    constexpr double slack = 0.025;
    const std::string words = oneLine(numbers.substr(0, 80));
    for (const double expected : usual) {
      const std::optional<double> number = doubleIn(takeWord(numbers));
      if (!number || !(std::abs(*number - expected) < slack))
        picture_.unfit = fmt::format(
            "has primaries of its own ({}); convert it to those of Rec. 709 (sRGB)", withoutBlanks(words));
    }
  }

  int byte() {
    if (rest_.empty()) cutOff();
    const int value = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    return value;
  }

  /// Reads a scanline: in the newer format four consecutive planes (R, G, B, exponent), otherwise pixels.
  void readScanline(std::string& out) {
    const auto size = std::size_t(width_);
    const std::string mark = {2, 2, static_cast<char>(width_ >> 8), static_cast<char>(width_ & 255)};
    planar_ = width_ >= 8 && width_ <= 0x7fff && rest_.starts_with(mark);
    if (!planar_) {
      readPixels(out);
      return;
    }
    rest_.remove_prefix(mark.size());
    for (std::size_t plane = 0; plane < 4; ++plane)
      for (std::size_t at = 0; at < size;) {
        int count = byte();
        const bool run = count > 128;
        if (run) count -= 128;
        if (count == 0 || at + std::size_t(count) > size) refuse("is corrupt (a run leaves its row)");
        const int value = run ? byte() : 0;
        for (; count > 0; --count) out[plane * size + at++] = static_cast<char>(run ? value : byte());
      }
  }

  /// Reads uncompressed pixels. A pixel with the mantissas 1, 1, 1 repeats the previous pixel as often as
  /// its fourth byte says. Consecutive repeat pixels are the digits of a base-256 count, lowest digit
  /// first.
  void readPixels(std::string& out) {
    unsigned shift = 0;
    for (std::size_t at = 0; at < out.size();) {
      if (rest_.size() < 4) cutOff();
      const std::string_view pixel = rest_.substr(0, 4);
      rest_.remove_prefix(4);
      if (!pixel.starts_with("\1\1\1")) {
        out.replace(at, 4, pixel);
        at += 4;
        shift = 0;
        continue;
      }
      const std::size_t bytes = 4 * (std::size_t{static_cast<unsigned char>(pixel[3])} << shift);
      if (at == 0 || shift > 16 || bytes > out.size() - at) refuse("is corrupt (a run leaves its row)");
      for (std::size_t k = 0; k < bytes; ++k, ++at) out[at] = out[at - 4];
      shift += 8;
    }
  }

  /// Decodes a component with the mantissa m and the exponent e as (m + 0.5) / 256 * 2^(e - 128); e = 0 is
  /// black. Writers truncate mantissas (setcolr), so m + 0.5 is the expected value, as in Radiance
  /// (colr_color), Blender and libvips: 1 is read back as 1.004, and the average brightness is preserved.
  /// Readers without the 0.5 are up to 0.8 % too dark.
  void setPixel(int x, int y, const std::string& scanline) {
    const auto at = [&](std::size_t channel) {
      const std::size_t i =
          planar_ ? channel * std::size_t(width_) + std::size_t(x) : 4 * std::size_t(x) + channel;
      return static_cast<unsigned char>(scanline[i]);
    };
    float* to = &picture_.values[4 * (std::size_t(y) * std::size_t(width_) + std::size_t(x))];
    to[3] = 1;
    for (std::size_t c = 0; c < 3; ++c)
      to[c] = at(3) == 0 ? 0.0F : std::ldexp(float(at(c)) + 0.5F, int{at(3)} - (128 + 8));
  }

  const std::string& label_;
  const std::string& advice_;
  std::size_t whole_;
  std::string_view rest_;
  int width_ = 0, height_ = 0;
  bool planar_ = false;
  LightFile picture_;
};

}  // namespace

bool isRadiance(std::string_view bytes) {
  return bytes.starts_with("#?");
}

LightFile decodeRadiance(std::string_view bytes, const std::string& label, const std::string& advice) {
  return RadianceFile(bytes, label, advice).read();
}

}  // namespace simreel::sim
