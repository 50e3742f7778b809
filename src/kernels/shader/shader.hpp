#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::kernels {

/// A value in a buffer or block.
struct Member {
  std::string name;
  std::string type;                ///< "float3", "Particle"; in GLSL "vec3"
  std::size_t offset = 0;          ///< in bytes, from the start of what it is in
  std::size_t bytes = 0;           ///< of one element, without gaps behind it
  std::vector<std::size_t> array;  ///< lengths, the outer one first; 0 is as many as the buffer has
  std::size_t stride = 0;          ///< from element to element of an array
  std::vector<Member> members;     ///< of a struct
  bool used = true;                ///< of a block: the kernel reads it
};

/// A storage buffer. In HLSL its one member is an array of its elements.
struct Buffer {
  std::string name;
  int binding = 0;
  bool reads = false, writes = false;
  std::string counterOf;   ///< the append or consume buffer whose counter this is
  std::string previousOf;  ///< the buffer whose state before the dispatch this has to hold
  /// The buffer or image whose shadow this is: `shadowWords` words for each word of the buffer, with its
  /// guards, or for each texel of the image; zeros before the run that records.
  std::string shadowOf;
  int shadowWords = 0;
  int guards =
      0;  ///< elements that the buffer has beyond its length: one of zeros, one that takes what is dropped
  std::vector<Member> members;
};

/// A texture or image, one binding each.
struct Texture {
  std::string name;
  std::string type;     ///< "2D", "3D", "2DArray", "Cube", "Buffer", "1D"
  std::string values;   ///< "float", "int", "uint"
  std::string format;   ///< of an image: "rgba32f"; empty for a texture that is only read
  std::string sampler;  ///< the sampler that it is read with; empty for reads of texels
  std::string uniform;  ///< its name in the GLSL text
  int binding = 0;      ///< an image unit or a texture unit
  bool reads = false, writes = false;
};

/// A uniform block; loose constants are in one without a name.
struct Block {
  std::string name;
  int binding = 0;
  std::size_t bytes = 0;
  std::vector<Member> members;
};

/// A place in a kernel where an invocation can go wrong. The block `Kernel::report` has four words for
/// each place, in the order of `Kernel::places`:
///
///   0  number of invocations whose first fault is here (uint)            initially 0
///   1  the lowest of these invocations, x first, then y, then z (uint)   0xFFFFFFFF
///   2  the lowest index (int); loops: iterations                         INT_MAX
///   3  the highest index (int)                                           INT_MIN
///
/// Of races, word 1 is the invocation that reads or writes, word 2 the lowest of the other invocations that
/// changed what it reads or stored another value, word 3 the highest index of an element; of an image that
/// is x + width * (y + height * z).
/// None depends on the order of invocations. To learn the indices of the invocation in word 1, run the
/// dispatch again from the same state with word 0 set to 0x80000000, word 1 kept, 2 and 3 as initially.
struct Place {
  std::string kind;  ///< "read" or "write" out of bounds; "loop" that reached the limit; "loops"
                     ///< that the driver ended; "race-read", "race-write" of what another invocation
                     ///< changes
  std::string what;  ///< the buffer, texture, array or struct member that the index is of, as the user
                     ///< named it; empty for loops
  std::string
      part;  ///< out of bounds of a texture: the axis, "x", "y" or "z"; race: the member of the element
  std::string file;  ///< as messages name it
  int line = 0;
  bool operator==(const Place&) const = default;
};

struct Kernel {
  std::string name;
  int line = 0;                                 ///< that announces it
  std::array<unsigned, 3> threads = {1, 1, 1};  ///< of a group
  /// Axes along which the kernel asks for the number of its invocation or group: 1 for x, 2 for y, 4 for z.
  unsigned axes = 0;
  std::vector<Buffer> buffers;
  std::vector<Texture> textures;
  std::vector<Block> blocks;
  int report = -1;  ///< the binding of the storage block of reports; -1: none
  std::vector<Place> places;
  std::string glsl;  ///< GLSL 4.5 with "#version"; loadShaderText() wants body()
  /// The text without the line "#version", which the loader of shaders writes itself.
  [[nodiscard]] std::string body() const;
};

struct Shader {
  std::string language;  ///< "HLSL" or "GLSL"
  std::vector<std::vector<std::string>> keywords;
  std::vector<Kernel> kernels;
  std::vector<std::string> files;  ///< the user's, the first and what it includes
};

/// As JSON, and back.
[[nodiscard]] std::string toJson(const Shader& shader, int indent = -1);
[[nodiscard]] Shader fromJson(const std::string& text);

}  // namespace simreel::kernels
