#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace simreel {

/// Type of an array's numbers, in the byte order of the machine.
enum class NumberType { float32, uint32, uint8 };

/// Array of numbers in CPU memory. The caller owns the memory. Axes run from slowest to fastest. An element
/// may occupy more bytes than its axis describes, so use `strides`.
struct Array {
  std::string name;  ///< name of the array, such as "positions", or of a field or layer
  std::string unit;  ///< unit, such as "m" or "m/s"; empty if unknown or mixed
  NumberType type = NumberType::float32;
  std::vector<std::size_t> shape;    ///< length of each axis, for example rows, columns, 3
  std::vector<std::size_t> strides;  ///< distance in bytes between consecutive entries along each axis
  std::vector<std::byte> bytes;

  /// Returns the number at `index`, which has one entry per axis. T must be the type that `type` names.
  template <class T>
  [[nodiscard]] const T& at(const std::vector<std::size_t>& index) const {
    std::size_t offset = 0;
    for (std::size_t i = 0; i < index.size(); ++i) offset += index[i] * strides[i];
    return *reinterpret_cast<const T*>(bytes.data() + offset);
  }
};

/// Description of a state array.
struct ArrayInfo {
  std::string object, name, unit;
  NumberType type = NumberType::float32;
  std::vector<std::size_t> shape;
  bool writable = false;  ///< false if the simulation computes the array from other arrays
};

/// Picture with 8 bits per channel, sRGB encoded, with rows from the top.
struct Picture {
  int width = 0, height = 0;
  int channels = 3;                 ///< number of channels: 3, or 4 with straight alpha if the scene has
                                    ///< render.transparent
  std::vector<std::uint8_t> bytes;  ///< pixel values; the size is width * height * channels
};

/// Frame that a scene has reached.
struct Frame {
  int number = 0;
  double time = 0;  ///< scene time (s)
};

/// Object of a scene.
struct ObjectInfo {
  std::string name;
  std::string kind;  ///< name of the kind in scenes, such as "cloth" or "particles"
};

/// Quantity that an object measures, such as an energy.
struct Quantity {
  std::string name, unit;
  double value = 0;
};

/// Result of one of the scene's checks at one frame.
struct CheckResult {
  std::string what;  ///< description, for example "max of flag positions.y"
  int frame = 0;
  double value = 0;  ///< measured value; NaN if the check does not measure a value
  bool passed = false;
  std::string problem;  ///< reason for the failure in one line; empty if the check passed
};

/// Triangle mesh in world space, with the object's placement applied.
struct Mesh {
  Array positions;  ///< positions (m), shape (n, 3)
  Array normals;    ///< normals, shape (n, 3)
  Array uvs;        ///< texture coordinates, shape (n, 2), with v = 0 at the top row; empty if the mesh has
                    ///< none
  Array triangles;  ///< vertex indices, shape (m, 3), uint32
};

/// Message that the command line would print.
struct Message {
  std::string level;  ///< severity: "warning", "info" or "detail"
  std::string text;
};

}  // namespace simreel
