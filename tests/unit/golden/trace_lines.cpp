// Tests the parser of the output of `simreel trace`, and the comparison of two states.
#include "golden/trace/lines.hpp"
#include "golden/trace/state_difference.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <doctest/doctest.h>

using namespace simreel::golden;

namespace {

std::uint32_t bitsOf(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

const StateDump dump{7, 2, {{"flag", "positions", {1, 2, 3, 4, 5, 6, 7, 8}}, {"flag", "none", {}}}};

}  // namespace

TEST_CASE("a trace's header line is read back") {
  TraceHeader header{"1.2.3", "driver \"x\"", "abc", "texel", "", {-12, {{"fläg", "positions", 63, 4}}}};
  for (const char* inexact : {"", "exactSin(1.5): GPU 1, CPU 2"}) {
    header.inexact = inexact;
    const auto read = readHeaderLine(headerLine(header));
    CHECK(read.version == header.version);
    CHECK(read.driver == header.driver);
    CHECK(read.fingerprint == header.fingerprint);
    CHECK(read.memoryPath == header.memoryPath);
    CHECK(read.inexact == header.inexact);
    CHECK(read.run.firstFrame == -12);
    CHECK(read.run.arrays == header.run.arrays);
  }
}

TEST_CASE("frame and step lines are read back") {
  const StateLine frame{-3, "", 0, 0, {{"b.positions", "00ff"}, {"a.velocities", "12"}}};
  CHECK(stateLine(frame) == R"({"frame":-3,"arrays":{"b.positions":"00ff","a.velocities":"12"}})");
  CHECK(readStateLine(stateLine(frame)) ==
        StateLine{-3, "", 0, 0, {{"a.velocities", "12"}, {"b.positions", "00ff"}}});
  const StateLine drawn{7, "", 0, 0, {}, {{"visibility", "0f"}, {"light", "1e"}}};
  CHECK(stateLine(drawn) == R"({"frame":7,"arrays":{},"passes":{"visibility":"0f","light":"1e"}})");
  CHECK(readStateLine(stateLine(drawn)) ==
        StateLine{7, "", 0, 0, {}, {{"light", "1e"}, {"visibility", "0f"}}});
  const StateLine step{5, "b", 2, 22, {{"b.positions", "00ff"}}};
  CHECK(readStateLine(stateLine(step)) == step);
  CHECK(stateLine(frame).find('\n') == std::string::npos);
}

TEST_CASE("a file that is not a trace is refused with its first bytes") {
  for (const std::string& text :
       {std::string("hello"), std::string(""), std::string("{}"), std::string("[1]"), std::string("null"),
        std::string("{\"frame\":\"x\",\"arrays\":{}}"), std::string(1000, '\x01')}) {
    CHECK_THROWS_AS(static_cast<void>(readHeaderLine(text)), std::runtime_error);
    CHECK_THROWS_AS(static_cast<void>(readStateLine(text)), std::runtime_error);
  }
  CHECK_THROWS_WITH(static_cast<void>(readHeaderLine("hello")),
                    "\"hello\" is no header of a trace: not valid JSON at byte 1");
  auto later = headerLine({});
  later.replace(later.find("\"trace\":1"), 9, "\"trace\":2");
  CHECK_THROWS_WITH(static_cast<void>(readHeaderLine(later)), "its trace has format 2, not 1");
}

TEST_CASE("a dump is read back, and a truncated or too long dump is refused") {
  const auto bytes = encodeDump(dump);
  const auto read = readDump(bytes);
  CHECK(read.frame == 7);
  CHECK(read.step == 2);
  REQUIRE(read.arrays.size() == 2);
  CHECK(read.arrays[0].object == "flag");
  CHECK(read.arrays[0].words == dump.arrays[0].words);
  CHECK(read.arrays[1].words.empty());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_THROWS_AS(static_cast<void>(readDump(std::span(bytes).first(size))), std::runtime_error);
  auto longer = bytes;
  longer.push_back(std::byte{0});
  CHECK_THROWS_AS(static_cast<void>(readDump(longer)), std::runtime_error);
}

TEST_CASE("a dump with absurd sizes is refused before memory is allocated") {
  for (const char* elements : {"18446744073709551615", "1152921504606846977", "-1", "1e300"}) {
    const std::string text =
        std::string(R"({"frame":0,"step":0,"arrays":[{"object":"a","array":"b","elements":)") + elements +
        "}]}\n0123456789abcdef";
    CHECK_THROWS_AS(static_cast<void>(readDump(std::as_bytes(std::span(text)))), std::runtime_error);
  }
}

TEST_CASE("numbers in trace lines that do not fit an int are refused") {
  for (const char* number : {"1e300", "2147483648", "-2147483649", "18446744073709551615", "1.5", "true"}) {
    const std::string line = R"({"frame":)" + std::string(number) + R"(,"arrays":{}})";
    CAPTURE(line);
    CHECK_THROWS_AS(static_cast<void>(readStateLine(line)), std::runtime_error);
  }
  CHECK(readStateLine(R"({"frame":-2147483648,"arrays":{}})").frame == std::numeric_limits<int>::min());
}

TEST_CASE("ulps count the floats between two values") {
  CHECK(ulpsBetween(bitsOf(1.0F), bitsOf(1.0F)) == 0);
  CHECK(ulpsBetween(bitsOf(1.0F), bitsOf(std::nextafter(1.0F, 2.0F))) == 1);
  CHECK(ulpsBetween(bitsOf(std::nextafter(1.0F, 0.0F)), bitsOf(std::nextafter(1.0F, 2.0F))) == 2);
  CHECK(ulpsBetween(bitsOf(0.0F), bitsOf(-0.0F)) == 0);
  const float min = std::numeric_limits<float>::denorm_min();
  CHECK(ulpsBetween(bitsOf(-min), bitsOf(min)) == 2);
  CHECK(ulpsBetween(bitsOf(1.0F), bitsOf(2.0F)) == 1U << 23U);
  CHECK(ulpsBetween(bitsOf(std::numeric_limits<float>::max()),
                    bitsOf(std::numeric_limits<float>::infinity())) == 1);
  CHECK(!ulpsBetween(bitsOf(std::nanf("")), bitsOf(1.0F)));
  CHECK(!ulpsBetween(0x7fc00000U, 0x7fc00001U));
}

TEST_CASE("comparing words returns the first differing element, the count and the max distance") {
  std::vector<std::uint32_t> here(4 * 9, bitsOf(1.0F));
  auto there = here;
  CHECK(compareWords(here, there).differing == 0);
  CHECK(compareWords(here, there).first == -1);
  there[4 * 3 + 2] = bitsOf(std::nextafter(1.0F, 2.0F));
  there[4 * 3 + 3] += 2;
  there[4 * 8] -= 7;
  here[4 * 5 + 1] = 0x7fc00000U;
  const auto found = compareWords(here, there);
  CHECK(found.elements == 9);
  CHECK(found.differing == 3);
  CHECK(found.first == 3);
  CHECK(found.here == std::array{bitsOf(1), bitsOf(1), bitsOf(1), bitsOf(1)});
  CHECK(found.there == std::array{bitsOf(1), bitsOf(1), bitsOf(1) + 1, bitsOf(1) + 2});
  CHECK(found.maxUlps == 7);
  CHECK(found.withNan == 1);
}

TEST_CASE("zeros of different sign differ although their ulp distance is 0") {
  const auto found = compareWords({0, 0, 0, 0}, {0, 0x80000000U, 0, 0});
  CHECK(found.differing == 1);
  CHECK(found.maxUlps == 0);
}
