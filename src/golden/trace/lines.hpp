#pragma once
#include "golden/trace/traced_run.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace simreel::golden {

// What `simreel trace` prints and `simreel bisect` reads: JSON, a line each, and one binary dump. Readers
// ignore members that they do not know, so builds of different versions understand each other. They throw
// std::runtime_error saying what is wrong with the text.

/// The first line: who traces what.
struct TraceHeader {
  std::string version, driver, fingerprint, memoryPath;
  std::string inexact;  ///< how the driver breaks exact numerics; empty: it does not
  TracedRun run;
};
[[nodiscard]] std::string headerLine(const TraceHeader& header);
[[nodiscard]] TraceHeader readHeaderLine(const std::string& line);

/// The state at a frame, or after one step of one object.
struct StateLine {
  int frame = 0;
  std::string object;  ///< empty: of a whole frame
  int step = 0;        ///< of `steps`, from 1; 0: of a whole frame
  int steps = 0;
  std::vector<std::pair<std::string, std::string>> arrays;  ///< "flag.positions", 32 hexadecimal digits
  std::vector<std::pair<std::string, std::string>> passes = {};  ///< of the frame's picture; hashesOf()
  bool operator==(const StateLine&) const = default;
};
[[nodiscard]] std::string stateLine(const StateLine& state);
/// Its arrays and passes are in the order of their names.
[[nodiscard]] StateLine readStateLine(const std::string& line);

/// An element of an array is a vec4 of 32-bit numbers.
constexpr std::size_t wordsPerElement = 4;
constexpr std::size_t bytesPerElement = wordsPerElement * sizeof(std::uint32_t);

/// The words of every state array: a JSON line that says which, then the words as little-endian 32-bit
/// floats, array by array.
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
