#include "frame/fast_deflate.hpp"
#include "frame/image.hpp"
#include "frame_test_help.hpp"

#include <bit>

#include <libdeflate.h>

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

/// All chunks, each with its CRC checked.
std::vector<Chunk> chunksOf(const std::vector<std::byte>& file) {
  std::vector<Chunk> chunks;
  const auto* text = reinterpret_cast<const char*>(file.data());
  for (std::size_t at = 8; at < file.size();) {
    const std::size_t length = bigEndian(file, at);
    REQUIRE(at + 12 + length <= file.size());
    chunks.push_back({std::string(text + at + 4, 4), std::string(text + at + 8, length)});
    CHECK(bigEndian(file, at + 8 + length) == libdeflate_crc32(0, file.data() + at + 4, length + 4));
    at += 12 + length;
  }
  return chunks;
}

void checkRoundTrip(const std::vector<std::uint8_t>& data) {
  std::vector<std::uint8_t> packed(fastZlibBound(data.size()));
  packed.resize(fastZlib(data, packed));
  std::vector<std::uint8_t> back(data.size() + 1);
  libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
  std::size_t size = 0;
  const auto result = libdeflate_zlib_decompress(decompressor, packed.data(), packed.size(), back.data(),
                                                 back.size(), &size);
  libdeflate_free_decompressor(decompressor);
  REQUIRE(result == LIBDEFLATE_SUCCESS);
  back.resize(size);
  CHECK((back == data));
}

}  // namespace

TEST_CASE("png: odd sizes come back exactly") {
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

TEST_CASE("png: the hash sees size and colour, not alpha") {
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

TEST_CASE("png: text chunks stand after the header, Latin-1 or international") {
  const auto file = encodePng(picture(8, 8), {{"Software", "simreel"},
                                              {"simreel:scene", "caf\xc3\xa9"},
                                              {"Title", "\xe9\x9b\xaa and \xc3\xa9"},
                                              {"Broken", std::string("a\xff\x80z\0!", 6)},
                                              {"Empty", ""}});
  const auto chunks = chunksOf(file);
  REQUIRE(chunks.size() == 8);
  CHECK(chunks[0].type == "IHDR");
  CHECK(chunks[1].type == "tEXt");
  CHECK(chunks[1].data == std::string("Software\0simreel", 16));
  CHECK(chunks[2].data == std::string("simreel:scene\0caf\xe9", 18));
  CHECK(chunks[3].type == "iTXt");
  CHECK(chunks[3].data == std::string("Title\0\0\0\0\0\xe9\x9b\xaa and \xc3\xa9", 20));
  CHECK(chunks[4].data == std::string("Broken\0a??z?!", 13));
  CHECK(chunks[5].data == std::string("Empty\0", 6));
  CHECK(chunks[6].type == "IDAT");
  CHECK(decodeImage(file, "test").width == 8);
}

TEST_CASE("png: a broken file is a user error that names it") {
  const auto file = encodePng(picture(40, 30), {});
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{5}, std::size_t{20}, std::size_t{60}, file.size() / 2}) {
    const auto [code, text] =
        errorOf([&] { (void)decodeImage(std::span(file).first(size), "broken.png"); });
    CHECK(code == ExitCode::inputOutput);
    CHECK(contains(text, "broken.png"));
  }
  auto huge = file;
  huge[16 + 2] = std::byte{0x7f};  // width 32552
  CHECK(errorOf([&] { (void)decodeImage(huge, "huge.png"); }).first == ExitCode::inputOutput);
  // Any single wrong byte either decodes to something or is a user error; it never crashes.
  for (std::size_t i = 0; i < file.size(); ++i) {
    auto wrong = file;
    wrong[i] ^= std::byte{0x5a};
    const auto code = errorOf([&] { (void)decodeImage(wrong, "wrong.png"); }).first;
    CHECK((code == ExitCode::ok || code == ExitCode::inputOutput));
  }
}

TEST_CASE("png: the compressor gives back what it got") {
  std::uint32_t state = 1;
  const auto random = [&] { return state = state * 1664525u + 1013904223u; };
  for (const std::size_t size :
       {0, 1, 2, 7, 8, 9, 64, 1000, 65535, 65536, 262143, 262144, 262145, 700000}) {
    std::vector<std::uint8_t> zeros(size), noise(size), few(size), ramp(size), mixed(size), skewed(size);
    for (std::size_t i = 0; i < size; ++i) {
      noise[i] = static_cast<std::uint8_t>(random() >> 24);
      few[i] = (random() >> 24) < 20 ? static_cast<std::uint8_t>(random() >> 30) : 0;
      ramp[i] = static_cast<std::uint8_t>(i / 3 + i % 3);
      mixed[i] = (i / 5000) % 2 == 0 ? noise[i] : static_cast<std::uint8_t>(i % 97);
      // Halving probabilities make a code as deep as it gets, past the limit of 12 bits.
      skewed[i] = static_cast<std::uint8_t>(std::countl_zero(random() | 1u));
    }
    for (const auto* data : {&zeros, &noise, &few, &ramp, &mixed, &skewed}) checkRoundTrip(*data);
  }
}
