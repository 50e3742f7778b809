#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace simreel::kernels {

/// A member of a buffer, block or struct.
struct Member {
  std::string name;
  std::string type;                ///< type in the source: "float3" or "Particle" in HLSL, "vec3" in GLSL
  std::size_t offset = 0;          ///< offset in bytes from the start of the enclosing buffer, block or
                                   ///< struct
  std::size_t bytes = 0;           ///< size of one element in bytes, without trailing padding
  std::vector<std::size_t> array;  ///< array lengths, outermost first; 0 for an unsized array
  std::size_t stride = 0;          ///< distance in bytes between consecutive array elements
  std::vector<Member> members;     ///< members of a struct
  bool used = true;                ///< true if the kernel reads the member; meaningful only in a uniform
                                   ///< block
};

/// A storage buffer. An HLSL buffer has one member, the array of its elements.
struct Buffer {
  std::string name;
  int binding = 0;
  bool reads = false, writes = false;
  std::string counterOf;   ///< name of the append or consume buffer that uses this buffer as its counter;
                           ///< empty for other buffers
  std::string previousOf;  ///< name of the buffer whose state before the dispatch the caller must copy
                           ///< here; empty for other buffers
  /// Name of the buffer or image for which this is the shadow. The shadow has `shadowWords` words per word
  /// of the buffer (including the guard elements) or per texel of the image. The caller must fill it with
  /// zeros before the recording run.
  std::string shadowOf;
  int shadowWords = 0;
  int guards = 0;  ///< number of extra elements after the buffer's end; the first one is always zero, and
                   ///< the second one receives dropped writes
  std::vector<Member> members;
};

/// A texture or image, which has its own binding.
struct Texture {
  std::string name;
  std::string type;     ///< type of the texture: "2D", "3D", "2DArray", "Cube", "Buffer" or "1D"; "2D[4]"
                        ///< for an array
  std::string values;   ///< component type: "float", "int" or "uint"
  std::string format;   ///< format of an image, such as "rgba32f"; empty for a texture
  std::string sampler;  ///< name of the sampler; empty if the texture is read only by texelFetch
  std::string uniform;  ///< name in the GLSL text
  int binding = 0;      ///< image unit or texture unit
  bool reads = false, writes = false;
};

/// A uniform block. Constants outside blocks are collected in a block with an empty name.
struct Block {
  std::string name;
  int binding = 0;
  std::size_t bytes = 0;
  std::vector<Member> members;
};

/// Source position in a kernel at which an invocation can cause a fault. The block `Kernel::report` has
/// four words for each place, in the order of `Kernel::places`:
///
///   0  number of invocations whose first fault is at this place (uint)  initially 0
///   1  the lowest of these invocations, x first, then y, then z (uint)  0xFFFFFFFF
///   2  the lowest faulty index (int); for loops: number of iterations   INT_MAX
///   3  the highest faulty index (int)                                   INT_MIN
///
/// For races, word 1 is the invocation with the access, word 2 is the lowest other invocation that changed
/// the word or stored another value, and word 3 is the highest element index (for an image x + width * (y +
/// height * z)).
/// No word depends on the execution order of invocations. To get the indices of the invocation in word 1,
/// the dispatch is run again from the same state with word 0 set to 0x80000000, word 1 unchanged, and words
/// 2 and 3 reset.
struct Place {
  /// Kind of the fault. "read" and "write": an out-of-bounds access. "loop": a loop that reached the limit.
  /// "loops": loops that the driver ended. "race-read" and "race-write": an access to an element that
  /// another invocation changes.
  std::string kind;
  /// Name in the user's source of the indexed buffer, texture, array or struct member. Empty for loops.
  std::string what;
  std::string part;  ///< for an out-of-bounds texture access, the axis "x", "y" or "z"; for a race, the
                     ///< member of the element
  std::string file;  ///< file name for messages
  int line = 0;
  bool operator==(const Place&) const = default;
};

struct Kernel {
  std::string name;
  int line = 0;                                 ///< line that declares the kernel
  std::array<unsigned, 3> threads = {1, 1, 1};  ///< size of a workgroup
  /// Bit mask of the axes along which the kernel reads the index of its invocation or workgroup: 1 for x, 2
  /// for y, 4 for z.
  unsigned axes = 0;
  std::vector<Buffer> buffers;
  std::vector<Texture> textures;
  std::vector<Block> blocks;
  int report = -1;  ///< binding of the report block; -1 if none exists
  std::vector<Place> places;
  std::string glsl;  ///< GLSL 4.5 text with "#version"; use body() for loadShaderText()
  /// Returns the text without the "#version" line, which the shader loader adds.
  [[nodiscard]] std::string body() const;
};

struct Shader {
  std::string language;  ///< "HLSL" or "GLSL"
  std::vector<std::vector<std::string>> keywords;
  std::vector<Kernel> kernels;
  std::vector<std::string> files;  ///< the user's files: the shader and its includes
};

/// Convert a shader to and from JSON. `indent` is the number of spaces per level, or -1 for a single line.
[[nodiscard]] std::string toJson(const Shader& shader, int indent = -1);
[[nodiscard]] Shader fromJson(const std::string& text);

}  // namespace simreel::kernels
