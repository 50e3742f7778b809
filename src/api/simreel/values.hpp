#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace simreel {

/// Type of an array's numbers, in the byte order of the machine.
enum class NumberType { float32, float64, int32, uint32, uint8 };

/// Member of a structure, for arrays whose elements are structures (such as buffers of user kernels).
struct Member {
  std::string name;  ///< path in the shader, such as "material.color"
  NumberType type = NumberType::float32;
  std::vector<std::size_t> shape;  ///< empty for one number
  std::size_t offset = 0;          ///< bytes from the start of the structure
};

/// Array of numbers or structures in CPU memory, which the caller owns. Axes run from slowest to fastest.
/// An element may occupy more bytes than its axis describes, so use `strides`.
struct Array {
  std::string name;                       ///< "positions", or the name of a field or layer
  std::string unit;                       ///< "m", "m/s" or empty if unknown or mixed
  NumberType type = NumberType::float32;  ///< type of the numbers; unused if there are members
  std::vector<std::size_t> shape;         ///< for example rows, columns, 3; without an axis for members
  std::vector<std::size_t> strides;       ///< bytes from one entry of each axis to the next
  std::vector<std::byte> bytes;
  std::vector<Member> members = {};  ///< members of the structures; empty for an array of numbers

  /// Returns the number or structure at an index of each axis. The type T must be the one that `type`
  /// names, or a structure with these members.
  template <class T>
  [[nodiscard]] const T& at(const std::vector<std::size_t>& index) const {
    std::size_t offset = 0;
    for (std::size_t i = 0; i < index.size(); ++i) offset += index[i] * strides[i];
    return *reinterpret_cast<const T*>(bytes.data() + offset);
  }
};

/// Copy of an array of numbers in the memory of a CUDA device, without gaps. The last axis is the fastest.
struct DeviceArray {
  NumberType type = NumberType::float32;
  std::vector<std::size_t> shape;
  std::shared_ptr<void> memory;  ///< address of the first number on the device; freed with its last owner
  int device = 0;                ///< number of the CUDA device
};

/// Description of a state array.
struct ArrayInfo {
  std::string object, name, unit;
  NumberType type = NumberType::float32;  ///< as in Array
  std::vector<std::size_t> shape;
  bool writable = false;         ///< false if the simulation computes the array from others
  std::vector<Member> members;   ///< members of the structures; empty for an array of numbers
  std::size_t elementBytes = 0;  ///< bytes from one structure to the next; 0 for an array of numbers
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
