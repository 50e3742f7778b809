#include "frame/file/field_file.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace simreel::frame {

namespace {

static_assert(std::endian::native == std::endian::little, "floats are written as they lie in memory");

/// Returns the header of NumPy format 1.0: magic, version, length of the remaining header, a Python
/// dictionary, spaces up to a multiple of 64 bytes, line feed.
std::string npyHeader(glm::ivec2 size) {
  std::string text =
      fmt::format("{{'descr': '<f4', 'fortran_order': False, 'shape': ({}, {}), }}", size.y, size.x);
  constexpr std::size_t fixed = 10;
  text.append(63 - (fixed + text.size()) % 64, ' ');
  text += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(text.size() & 255U);
  header += static_cast<char>(text.size() >> 8U);
  return header + text;
}

}  // namespace

FieldFormat parseFieldFormat(const std::string& name) {
  if (name == "npy") return FieldFormat::npy;
  if (name == "pfm") return FieldFormat::pfm;
  fail(ExitCode::usage, "\"{}\" is not a format of fields; use npy or pfm", name);
}

FieldChoice parseFieldChoice(const std::string& text) {
  FieldChoice choice;
  bool format = false;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    begin = end + 1;
    if (item.empty()) fail(ExitCode::usage, "--fields {}: a name is empty; write NAME,NAME", text);
    if (item != "npy" && item != "pfm") {
      choice.names.push_back(item);
      continue;
    }
    if (format) fail(ExitCode::usage, "--fields {}: give one format, npy or pfm", text);
    choice.format = parseFieldFormat(item);
    format = true;
  }
  return choice;
}

const char* extension(FieldFormat format) {
  return format == FieldFormat::npy ? "npy" : "pfm";
}

std::vector<std::byte> encodeField(FieldFormat format, glm::ivec2 size, std::span<const float> values) {
  const auto rows = static_cast<std::size_t>(size.y);
  const std::size_t rowBytes = static_cast<std::size_t>(size.x) * sizeof(float);
  SIMREEL_CHECK_EQ(values.size_bytes(), rows * rowBytes);
  const bool npy = format == FieldFormat::npy;
  // A negative scale factor in a PFM header means little endian.
  const std::string header = npy ? npyHeader(size) : fmt::format("Pf\n{} {}\n-1.0\n", size.x, size.y);
  std::vector<std::byte> file(header.size() + values.size_bytes());
  std::memcpy(file.data(), header.data(), header.size());
  const auto bytes = std::as_bytes(values);
  for (std::size_t row = 0; row < rows; ++row)
    std::memcpy(&file[header.size() + (npy ? row : rows - 1 - row) * rowBytes], &bytes[row * rowBytes],
                rowBytes);
  return file;
}

}  // namespace simreel::frame
