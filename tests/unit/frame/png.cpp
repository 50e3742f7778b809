#include "frame/image.hpp"
#include "help.hpp"
#include "sim/grid/stb_picture.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <thread>

#include <isa-l/crc.h>

using namespace simreel;
using namespace simreel::frame;
using namespace simreel::frame::test;

namespace {

struct Chunk {
  std::string type;
  std::string data;
};

std::uint32_t bigEndian(const std::vector<std::byte>& file, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<std::uint32_t>(file.at(at + i));
  return value;
}

/// Checks the CRCs of all chunks and returns the chunks.
std::vector<Chunk> chunksOf(const std::vector<std::byte>& file) {
  std::vector<Chunk> chunks;
  const auto* text = reinterpret_cast<const char*>(file.data());
  for (std::size_t at = 8; at < file.size();) {
    const std::size_t length = bigEndian(file, at);
    REQUIRE(at + 12 + length <= file.size());
    chunks.push_back({std::string(text + at + 4, 4), std::string(text + at + 8, length)});
    CHECK(bigEndian(file, at + 8 + length) ==
          crc32_gzip_refl(0, reinterpret_cast<const unsigned char*>(file.data()) + at + 4, length + 4));
    at += 12 + length;
  }
  return chunks;
}

/// Checks that a picture with the given colours decodes exactly, and that encoding it twice gives equal
/// bytes.
void checkRoundTrip(int width, int height, std::uint8_t (*byte)(std::size_t)) {
  CAPTURE(width);
  CAPTURE(height);
  Image image{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 4, 255)};
  for (std::size_t i = 0; i < image.bytes.size(); ++i)
    if (i % 4 != 3) image.bytes[i] = byte(i);
  const auto file = encodePng(image, {});
  CHECK((decodeImage(file, "test").bytes == image.bytes));
  CHECK((encodePng(image, {}) == file));
  // For noise, the file must not be larger than with stored blocks, plus the other chunks.
  CHECK(file.size() < image.bytes.size() / 4 * 3 + std::size_t(height) * 2 + 1024);
}

std::uint32_t random(std::size_t i) {
  std::uint32_t state = static_cast<std::uint32_t>(i) * 747796405u + 2891336453u;
  state = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (state >> 22u) ^ state;
}

}  // namespace

TEST_CASE("png: odd sizes are read back exactly") {
  for (const auto& [width, height] : {std::pair{1, 1}, {3, 5}, {2, 1}, {1, 300}, {641, 359}, {1920, 400}}) {
    const Image image = picture(width, height);
    const auto file = encodePng(image, {});
    const Image back = decodeImage(file, "test");
    CHECK(back.width == width);
    CHECK(back.height == height);
    CHECK((back.bytes == image.bytes));
    CHECK(pixelHash(back) == pixelHash(image));
    CHECK(chunksOf(file).back().type == "IEND");
  }
}

TEST_CASE("png: the hash depends on size and colour, not on alpha") {
  Image image = picture(6, 4);
  const std::string hash = pixelHash(image);
  CHECK(hash.size() == 32);
  image.bytes[3] = 9;
  CHECK(pixelHash(image) == hash);
  image.bytes[2] ^= 1;
  CHECK(pixelHash(image) != hash);
  const Image wide{4, 1, std::vector<std::uint8_t>(16)}, square{2, 2, std::vector<std::uint8_t>(16)};
  CHECK(pixelHash(wide) != pixelHash(square));
}

TEST_CASE("png: text chunks follow the header, as Latin-1 or international text") {
  const auto file = encodePng(picture(8, 8), {{"Software", "simreel"},
                                              {"simreel:scene", "caf\xc3\xa9"},
                                              {"Title", "\xe9\x9b\xaa and \xc3\xa9"},
                                              {"Broken", std::string("a\xff\x80z\0!", 6)},
                                              {"Empty", ""}});
  const auto chunks = chunksOf(file);
  REQUIRE(chunks.size() == 11);
  CHECK(chunks[0].type == "IHDR");
  CHECK(chunks[4].type == "tEXt");
  CHECK(chunks[4].data == std::string("Software\0simreel", 16));
  CHECK(chunks[5].data == std::string("simreel:scene\0caf\xe9", 18));
  CHECK(chunks[6].type == "iTXt");
  CHECK(chunks[6].data == std::string("Title\0\0\0\0\0\xe9\x9b\xaa and \xc3\xa9", 20));
  CHECK(chunks[7].data == std::string("Broken\0a??z?!", 13));
  CHECK(chunks[8].data == std::string("Empty\0", 6));
  CHECK(chunks[9].type == "IDAT");
  CHECK(decodeImage(file, "test").width == 8);
}

TEST_CASE("png: files declare sRGB with the gamma and primaries of the specification") {
  const auto chunks = chunksOf(encodePng(picture(8, 8), {}));
  REQUIRE(chunks.size() == 6);
  CHECK(chunks[1].type == "sRGB");
  CHECK(chunks[1].data == std::string(1, '\0'));
  // The expected values are in the table of section 11.3.3.5 of the PNG specification.
  CHECK(chunks[2].type == "gAMA");
  CHECK(chunks[2].data == std::string("\x00\x00\xb1\x8f", 4));
  CHECK(chunks[3].type == "cHRM");
  CHECK(chunks[3].data.substr(0, 8) == std::string("\x00\x00\x7a\x26\x00\x00\x80\x84", 8));
  CHECK(chunks[3].data.size() == 32);
}

TEST_CASE("png: a broken file is a user error that names the file") {
  const auto file = encodePng(picture(40, 30), {});
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{5}, std::size_t{20}, std::size_t{60}, file.size() / 2}) {
    const auto [code, text] =
        errorOf([&] { (void)decodeImage(std::span(file).first(size), "broken.png"); });
    CHECK(code == ExitCode::inputOutput);
    CHECK(contains(text, "broken.png"));
  }
  auto huge = file;
  huge[16 + 2] = std::byte{0x7f};  // changes the width to 32552
  CHECK(errorOf([&] { (void)decodeImage(huge, "huge.png"); }).first == ExitCode::inputOutput);
  const std::string deep = "P5 64 64 65535\n" + std::string(std::size_t{64} * 64 * 2, 'x');
  CHECK(errorOf([&] { (void)decodeImage(std::as_bytes(std::span(deep)), "deep.pgm"); }).first ==
        ExitCode::inputOutput);
  // A file with any single wrong byte must decode or cause a UserError. It must not crash.
  for (std::size_t i = 0; i < file.size(); ++i) {
    auto wrong = file;
    wrong[i] ^= std::byte{0x5a};
    const auto code = errorOf([&] { (void)decodeImage(wrong, "wrong.png"); }).first;
    CHECK((code == ExitCode::ok || code == ExitCode::inputOutput));
  }
}

TEST_CASE("png: decompressing returns the compressed bytes") {
  // The filtered rows have 4 to 2 million bytes. Some sizes are close to the 64 KiB of a stored block.
  for (const auto& [width, height] : {std::pair{1, 1},
                                      {2, 2},
                                      {3, 7},
                                      {7, 3},
                                      {100, 100},
                                      {5461, 4},
                                      {13, 1638},
                                      {4369, 5},
                                      {148, 147},
                                      {300, 290},
                                      {1000, 700}}) {
    checkRoundTrip(width, height, [](std::size_t) { return std::uint8_t{0}; });
    checkRoundTrip(width, height, [](std::size_t i) { return static_cast<std::uint8_t>(random(i) >> 24); });
    checkRoundTrip(width, height, [](std::size_t i) {
      return (random(i) >> 24) < 20 ? static_cast<std::uint8_t>(random(i) & 3) : std::uint8_t{0};
    });
    checkRoundTrip(width, height, [](std::size_t i) {
      return static_cast<std::uint8_t>((i / 5000) % 2 == 0 ? random(i) >> 24 : i % 97);
    });
    // The probability of each byte value is half of the previous one, which gives the deepest Huffman
    // codes.
    checkRoundTrip(width, height, [](std::size_t i) {
      return static_cast<std::uint8_t>(std::countl_zero(random(i) | 1u));
    });
  }
}

TEST_CASE(
    "png: the first bytes are stored uncompressed, because a compressor without history would hash an "
    "address") {
  // Regression test. Without a dictionary, the compressor hashed an address and chose other matches in 2 of
  // 100,000 runs. The data start with 7 bytes of headers, then the first 32 bytes of the rows.
  const auto chunks = chunksOf(encodePng(picture(96, 54), {}));
  const auto data =
      std::find_if(chunks.begin(), chunks.end(), [](const Chunk& c) { return c.type == "IDAT"; });
  REQUIRE(data != chunks.end());
  CHECK(data->data.starts_with(std::string("\x78\x01\x00\x20\x00\xdf\xff", 7)));
  CHECK(chunksOf(encodePng(picture(1, 1), {}))
            .at(4)
            .data.starts_with(std::string("\x78\x01\x01\x04\x00\xfb\xff\x01", 8)));
}

TEST_CASE("png: many threads encode the same bytes as one thread") {
  std::vector<Image> images;
  std::vector<std::vector<std::byte>> expected;
  for (int i = 0; i < 6; ++i) {
    images.push_back(picture(40 + 90 * i, 30 + 50 * i));
    expected.push_back(encodePng(images.back(), {}));
  }
  std::array<std::vector<std::vector<std::byte>>, 4> got;
  std::vector<std::thread> threads;
  for (auto& files : got)
    threads.emplace_back([&files, &images] {
      for (int round = 0; round < 3; ++round)
        for (const Image& image : images) files.push_back(encodePng(image, {}));
    });
  for (std::thread& thread : threads) thread.join();
  for (const auto& files : got) {
    REQUIRE(files.size() == 3 * expected.size());
    for (std::size_t i = 0; i < files.size(); ++i) CHECK((files[i] == expected[i % expected.size()]));
  }
}

TEST_CASE("png: 16-bit grey values are linear and are read back") {
  const std::vector<std::uint8_t> bytes = {0x12, 0x34, 0xff, 0xff, 0, 0, 0, 1, 0x80, 0, 0xab, 0xcd};
  const auto file = encodePng({{3, 2}, 1, 16, bytes, true}, {{"Software", "simreel"}});
  const auto chunks = chunksOf(file);
  REQUIRE(chunks.size() == 6);
  CHECK(chunks[0].data == std::string("\0\0\0\x03\0\0\0\x02\x10\0\0\0\0", 13));
  CHECK(chunks[1].type == "gAMA");
  CHECK(chunks[1].data == std::string("\x00\x01\x86\xa0", 4));
  CHECK(chunks[2].type == "cHRM");
  const auto values =
      sim::stbDecode<std::uint16_t>({reinterpret_cast<const char*>(file.data()), file.size()}, {3, 2}, 1);
  REQUIRE(values);
  CHECK(*values == std::vector<std::uint16_t>{0x1234, 0xffff, 0, 1, 0x8000, 0xabcd});
}
