#pragma once
#include "golden/trace/traced_run.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::golden {

// Text output of `simreel trace`, which `simreel bisect` reads. It has one JSON object per line, and a
// binary dump. Readers ignore unknown members, so that different versions are compatible. Readers throw
// std::runtime_error with a text that describes the mistake.

/// First line of a trace: the program, driver and traced run.
struct TraceHeader {
  std::string version, driver, fingerprint, memoryPath;
  std::string inexact;  ///< description of how the driver violates exact numerics; empty if it does not
  TracedRun run;
};
[[nodiscard]] std::string headerLine(const TraceHeader& header);
[[nodiscard]] TraceHeader readHeaderLine(const std::string& line);

/// State hashes at a frame, or after one step of one object.
struct StateLine {
  int frame = 0;
  std::string object;  ///< object name; empty if the line is for a frame
  int step = 0;        ///< number of the step, from 1 to `steps`; 0 if the line is for a frame
  int steps = 0;
  /// name of each array, such as "flag.positions", and its hash of 32 hexadecimal digits
  std::vector<std::pair<std::string, std::string>> arrays;
  /// name and hash of each pass of the frame's picture, from hashesOf()
  std::vector<std::pair<std::string, std::string>> passes = {};
  bool operator==(const StateLine&) const = default;
};
[[nodiscard]] std::string stateLine(const StateLine& state);
/// Parses a state line. Arrays and passes are sorted by name.
[[nodiscard]] StateLine readStateLine(const std::string& line);

/// An array element is a vec4 of 32-bit values.
constexpr std::size_t wordsPerElement = 4;
constexpr std::size_t bytesPerElement = wordsPerElement * sizeof(std::uint32_t);

/// Content of all state arrays. The format is a JSON line that lists the arrays, followed by the words of
/// all arrays in sequence, as little-endian 32-bit floats.
struct StateDump {
  struct Array {
    std::string object, array;
    std::vector<std::uint32_t> words;  ///< bits of x, y, z, w of each element
  };
  int frame = 0;
  int step = 0;
  std::vector<Array> arrays;
};
[[nodiscard]] std::vector<std::byte> encodeDump(const StateDump& dump);
[[nodiscard]] StateDump readDump(std::span<const std::byte> bytes);

}  // namespace simreel::golden
