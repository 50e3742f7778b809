// Tests files designed to exhaust memory, stack or time. Their declared sizes must be checked and refused
// before any memory is allocated for them.
#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "base/version.hpp"
#include "frame/file/checkpoint.hpp"
#include "frame/file/manifest.hpp"
#include "frame/image.hpp"
#include "golden/baseline/baseline.hpp"
#include "golden/files/png_check.hpp"
#include "golden/report/json.hpp"
#include "golden/result.hpp"
#include "golden/trace/lines.hpp"
#include "sim/grid/picture_file.hpp"
#include "sim/life/plan.hpp"
#include "unit/help.hpp"
#include "unit/hostile/hostile.hpp"

#include <cstdint>
#include <string>
#include <sys/stat.h>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <isa-l/crc.h>
#include <isa-l/igzip_lib.h>
#include <nlohmann/json.hpp>

using namespace simreel;
using namespace simreel::test;

namespace {

std::string bigEndian(std::uint32_t value) {
  return {static_cast<char>(value >> 24), static_cast<char>(value >> 16), static_cast<char>(value >> 8),
          static_cast<char>(value)};
}

std::string pngChunk(const std::string& type, const std::string& data) {
  const std::string body = type + data;
  return bigEndian(static_cast<std::uint32_t>(data.size())) + body +
         bigEndian(crc32_gzip_refl(0, reinterpret_cast<const unsigned char*>(body.data()), body.size()));
}

/// Returns `count` zeros as a zlib stream.
std::string zeros(std::size_t count) {
  isal_zstream stream;
  isal_deflate_init(&stream);
  stream.gzip_flag = IGZIP_ZLIB;
  std::vector<unsigned char> in(std::size_t{1} << 20), out(std::size_t{1} << 20);
  std::string packed;
  while (count > 0) {
    const std::size_t part = std::min(count, in.size());
    count -= part;
    stream.next_in = in.data();
    stream.avail_in = static_cast<std::uint32_t>(part);
    stream.end_of_stream = count == 0 ? 1 : 0;
    do {
      stream.next_out = out.data();
      stream.avail_out = static_cast<std::uint32_t>(out.size());
      REQUIRE(isal_deflate(&stream) == COMP_OK);
      packed.append(reinterpret_cast<const char*>(out.data()), out.size() - stream.avail_out);
    } while (stream.avail_out == 0);
  }
  return packed;
}

/// Returns an 8-bit RGB PNG with these compressed pixels.
std::string png(std::uint32_t width, std::uint32_t height, const std::string& pixels) {
  return "\x89PNG\r\n\x1a\n" +
         pngChunk("IHDR", bigEndian(width) + bigEndian(height) + std::string("\x08\x02\0\0\0", 5)) +
         pngChunk("IDAT", pixels) + pngChunk("IEND", "");
}

}  // namespace

TEST_CASE(
    "JSON nested a million levels deep is refused in manifest, checkpoint, report, baseline and trace") {
  const std::string deep = times(1'000'000, R"({"a":)") + "1" + times(1'000'000, "}");
  checkHas(refusal([&] { static_cast<void>(frame::parseManifest(deep, "m.json")); }), "nested deeper");
  checkHas(refusal([&] { static_cast<void>(golden::parseReport(deep, "r.json")); }), "nested deeper");
  checkHas(refusal([&] { static_cast<void>(golden::parseState(deep, "b.json")); }), "nested deeper");
  checkHas(refusal([&] { static_cast<void>(golden::readHeaderLine(deep)); }), "nested deeper");
  const std::string header = R"({"format":"simreel-checkpoint","program":"","simulation":)" + deep + "}\n";
  const TemporaryFile file("deep.checkpoint", header + hashHex(header));
  const std::string none = refusal([&] { CHECK(!frame::Checkpoint::read(file.path(), {}, 10)); });
  CHECK(none == "nothing was refused");  // An invalid checkpoint causes a warning, and the run starts over.
}

TEST_CASE("a checkpoint whose size does not match its header is ignored, also with a valid hash") {
  frame::RunInfo run;
  run.width = run.height = 8;
  const auto reads = [&](const char* sizes, const char* payload) {
    const std::string text =
        fmt::format(R"({{"format":"simreel-checkpoint","program":"{}","simulation":"","numerics":"exact",)"
                    R"("frame":3,"state":"s",{}}})",
                    version(), sizes) +
        "\n" + payload;
    const TemporaryFile file("sizes.checkpoint", text + hashHex(text));
    return frame::Checkpoint::read(file.path(), run, 10).has_value();
  };
  const char* sizes = R"("counts":2,"parts":[["a","b",3],["a","c",1]])";
  CHECK(reads(sizes, "123456"));
  CHECK(!reads(sizes, "12345"));
  CHECK(!reads(sizes, "1234567"));
  CHECK(!reads(R"("counts":2,"parts":[["a","b",-3],["a","c",7]])", "123456"));
  CHECK(!reads(R"("counts":18446744073709551615,"parts":[["a","b",7]])", "123456"));
}

TEST_CASE("a manifest number that does not fit an int is refused, also if it would wrap") {
  frame::Manifest manifest;
  manifest.run.seed = 77;
  const std::string text = frame::manifestText(manifest);
  const std::size_t at = text.find("77");
  REQUIRE(at != std::string::npos);
  for (const char* number : {"2147483648", "4294967295", "18446744073709551615", "-2147483649", "1e300"}) {
    std::string other = text;
    other.replace(at, 2, number);
    CAPTURE(number);
    checkHas(refusal([&] { static_cast<void>(frame::parseManifest(other, "m.json")); }), "seed must be ");
  }
}

TEST_CASE("pictures that decompress beyond their size, or declare impossible sizes, are refused") {
  const auto whole = [](const std::string& text) { return std::as_bytes(std::span(text)); };
  CHECK(frame::decodeImage(whole(png(100, 100, zeros(100 * 301))), "whole.png").bytes.size() == 40000);
  const TemporaryFile bomb("bomb.png", png(100, 100, zeros(3'000'000'000)));
  checkHas(refusal([&] { static_cast<void>(sim::loadPicture(bomb.path(), "texture", 16384)); }),
           "holds more than the 100x100");
  checkHas(refusal([&] { static_cast<void>(golden::readPng(bomb.path(), "image")); }), "holds more than");
  const std::string vast = png(16384, 16384, zeros(1000));
  checkHas(refusal([&] { static_cast<void>(frame::decodeImage(whole(vast), "vast.png")); }),
           "do not fit in its");
}

TEST_CASE("pipes and devices as inputs are refused at once") {
  const std::filesystem::path pipe = std::filesystem::temp_directory_path() / "simreel-hostile-pipe";
  std::filesystem::remove(pipe);
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  for (const std::filesystem::path& file : {pipe, std::filesystem::path("/dev/zero")}) {
    checkHas(refusal([&] { static_cast<void>(readFile(file, "texture")); }), "is a pipe, a device");
    checkHas(refusal([&] { static_cast<void>(golden::readPng(file, "image")); }), "is a pipe, a device");
  }
  std::filesystem::remove(pipe);
}

TEST_CASE("a pattern listed 4096 times is read once, and its cells are counted before they are set") {
  std::string rows;
  for (int y = 0; y < 1000; ++y) rows += times(500, "bo") + "$\n";
  const TemporaryFile file("large.rle", "x = 1000, y = 1000\n" + rows + "!\n");
  sim::LifeParameters parameters;
  parameters.size = {1024, 1024};
  sim::LifePattern pattern;
  pattern.file = file.path();
  parameters.patterns.assign(33, pattern);
  CHECK(refusal([&] { static_cast<void>(sim::LifePlan(parameters, "cells", 1, 0.1).firstCells()); }) ==
        "nothing was refused");
  parameters.patterns.assign(4096, pattern);
  checkHas(refusal([&] { static_cast<void>(sim::LifePlan(parameters, "cells", 1, 0.1)); }),
           "4096 patterns have 2048000000 living cells");
}

TEST_CASE("pictures with line breaks in chunk names are refused in one line") {
  std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x08\0\0\0\x08\x08\x03\0\0\0\0\0\0\0", 33);
  bytes += std::string(
      "\0\0\0\x04\n\x1b]\x07"
      "abcd\0\0\0\0",
      16);
  try {
    (void)sim::decodePicture(bytes, "odd.png", "texture", 4096);
    FAIL("read as a picture");
  } catch (const UserError& error) {
    CHECK(std::string(error.what()).find("odd.png") != std::string::npos);
    CHECK(std::string(error.what()).find_first_of("\n\x1b\x07") == std::string::npos);
  }
}

TEST_CASE("pictures with many-digit numbers in any header field are refused") {
  const auto refusal = [](const std::string& text) -> std::string {
    try {
      (void)sim::decodePicture(text, "odd.ppm", "texture", 4096);
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  for (const char* text : {"P666666666666666666", "P6\n# 1\n9999999999 1\n255\nabc",
                           "P5 1 18446744073709551617 255\na", "P5 1 1 #x\n#y\r\n 99999999999\na"}) {
    CAPTURE(text);
    CHECK(refusal(text).find("nine digits") != std::string::npos);
  }
  // Digits in a comment or in the pixels are not part of the header's numbers.
  CHECK(refusal("P5\n# 12345678901\n11 1 255\n12345678901").empty());
}
