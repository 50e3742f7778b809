// Tests NPY and PFM files byte by byte.
#include "frame/file/field_file.hpp"

#include "base/error.hpp"

#include <cstring>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

float floatAt(const std::vector<std::byte>& file, std::size_t at) {
  float value = 0;
  std::memcpy(&value, &file.at(at), 4);
  return value;
}

std::string textOf(const std::vector<std::byte>& file, std::size_t bytes) {
  return {reinterpret_cast<const char*>(file.data()), bytes};
}

}  // namespace

TEST_CASE("an NPY file has version 1.0, aligned data and the top row first") {
  const std::vector<float> values = {1, 2, 3, 4, 5, 6.25F};
  const auto file = frame::encodeField(frame::FieldFormat::npy, {3, 2}, values);
  const std::size_t header = file.size() - 24;
  CHECK(header % 64 == 0);
  CHECK(textOf(file, 8) == std::string("\x93NUMPY\x01\x00", 8));
  CHECK(static_cast<std::size_t>(file[8]) + 256 * static_cast<std::size_t>(file[9]) == header - 10);
  const std::string text = textOf(file, header).substr(10);
  CHECK(text.starts_with("{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), } "));
  CHECK(text.back() == '\n');
  CHECK(floatAt(file, header) == 1);
  CHECK(floatAt(file, header + 12) == 4);
  CHECK(floatAt(file, header + 20) == 6.25F);
}

TEST_CASE("the header of an NPY file is a multiple of 64 bytes for every size") {
  for (const int wide : {1, 9, 10, 12345, 1000000}) {
    const std::vector<float> values(static_cast<std::size_t>(wide), 1.0F);
    CHECK((frame::encodeField(frame::FieldFormat::npy, {wide, 1}, values).size() - values.size() * 4) %
              64 ==
          0);
  }
}

TEST_CASE("a PFM file is little endian with the bottom row first") {
  const std::vector<float> values = {1, 2, 3, 4, 5, 6};
  const auto file = frame::encodeField(frame::FieldFormat::pfm, {3, 2}, values);
  const std::string header = "Pf\n3 2\n-1.0\n";
  REQUIRE(file.size() == header.size() + 24);
  CHECK(textOf(file, header.size()) == header);
  CHECK(floatAt(file, header.size()) == 4);
  CHECK(floatAt(file, header.size() + 12) == 1);
}

TEST_CASE("field formats are npy and pfm only") {
  CHECK(frame::parseFieldFormat("npy") == frame::FieldFormat::npy);
  CHECK(frame::parseFieldFormat("pfm") == frame::FieldFormat::pfm);
  CHECK_THROWS_AS(static_cast<void>(frame::parseFieldFormat("tiff")), UserError);
}
