#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::kernels {

/// A member of a buffer, block or struct.
struct Member {
  std::string name;
  std::string type;                ///< HLSL: "float3", "Particle"; GLSL: "vec3"
  std::size_t offset = 0;          ///< bytes from the start of the enclosing buffer, block or struct
  std::size_t bytes = 0;           ///< size of one element, without trailing padding
  std::vector<std::size_t> array;  ///< array lengths, outermost first; 0: unsized
  std::size_t stride = 0;          ///< bytes between elements of an array
  std::vector<Member> members;     ///< members of a struct
  bool used = true;                ///< only in a block: true if the kernel reads it
};

/// A storage buffer. An HLSL buffer has one member, the array of its elements.
struct Buffer {
  std::string name;
  int binding = 0;
  bool reads = false, writes = false;
  std::string counterOf;   ///< name of the append or consume buffer whose counter this is
  std::string previousOf;  ///< name of the buffer whose state before the dispatch the caller must copy here
  /// Name of the buffer or image whose shadow this is. The shadow has `shadowWords` words per word of the
  /// buffer (including its guards) or per texel of the image. The caller must fill it with zeros before the
  /// recording run.
  std::string shadowOf;
  int shadowWords = 0;
  int guards = 0;  ///< number of extra elements behind the buffer's length: one of zeros, one that absorbs
                   ///< dropped writes
  std::vector<Member> members;
};

/// A texture or image with its own binding.
struct Texture {
  std::string name;
  std::string type;     ///< "2D", "3D", "2DArray", "Cube", "Buffer", "1D"; "2D[4]" for an array
  std::string values;   ///< "float", "int", "uint"
  std::string format;   ///< format of an image, such as "rgba32f"; empty for a texture
  std::string sampler;  ///< name of the sampler; empty if only texelFetch reads it
  std::string uniform;  ///< name in the GLSL text
  int binding = 0;      ///< image unit or texture unit
  bool reads = false, writes = false;
};

/// A uniform block. Constants outside blocks are in a block without a name.
struct Block {
  std::string name;
  int binding = 0;
  std::size_t bytes = 0;
  std::vector<Member> members;
};

/// Source position in a kernel at which an invocation can cause a fault. The block `Kernel::report` has
/// four words for each place, in the order of `Kernel::places`:
///
///   0  number of invocations whose first fault is here (uint)            initially 0
///   1  the lowest of these invocations, x first, then y, then z (uint)   0xFFFFFFFF
///   2  the lowest index (int); loops: iterations                         INT_MAX
///   3  the highest index (int)                                           INT_MIN
///
/// For races, word 1 is the invocation with the access, word 2 is the lowest other invocation that changed
/// the word or stored another value, and word 3 is the highest element index (for an image x + width * (y +
/// height * z)).
/// No word depends on the execution order of invocations. To get the indices of the invocation in word 1,
/// run the dispatch again from the same state with word 0 set to 0x80000000, word 1 kept, and words 2 and 3
/// reset.
struct Place {
  /// "read" or "write" out of bounds; "loop" at its limit; "loops" ended by the driver; "race-read" or
  /// "race-write" of an element that another invocation changes
  std::string kind;
  /// user's name of the indexed buffer, texture, array or struct member; empty for loops
  std::string what;
  std::string part;  ///< texture out of bounds: the axis "x", "y" or "z"; race: the member of the element
  std::string file;  ///< file name for messages
  int line = 0;
  bool operator==(const Place&) const = default;
};

struct Kernel {
  std::string name;
  int line = 0;                                 ///< line that declares the kernel
  std::array<unsigned, 3> threads = {1, 1, 1};  ///< size of a workgroup
  /// Bit mask of the axes along which the kernel reads the index of its invocation or group: 1 x, 2 y, 4 z.
  unsigned axes = 0;
  std::vector<Buffer> buffers;
  std::vector<Texture> textures;
  std::vector<Block> blocks;
  int report = -1;  ///< binding of the report block; -1: none
  std::vector<Place> places;
  std::string glsl;  ///< GLSL 4.5 text with "#version"; loadShaderText() takes body() instead
  /// Returns the text without the "#version" line, which the shader loader adds itself.
  [[nodiscard]] std::string body() const;
};

struct Shader {
  std::string language;  ///< "HLSL" or "GLSL"
  std::vector<std::vector<std::string>> keywords;
  std::vector<Kernel> kernels;
  std::vector<std::string> files;  ///< the user's files: the shader and its includes
};

/// Conversions to and from JSON.
[[nodiscard]] std::string toJson(const Shader& shader, int indent = -1);
[[nodiscard]] Shader fromJson(const std::string& text);

}  // namespace simreel::kernels
