#pragma once
#include "kernels/shader/shader.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace simreel::kernels {

/// A dispatch's races are found in two runs from the same state: one records in shadow buffers which
/// invocation changed each word (Buffer::shadowOf), one compares each access with the shadows.
enum class Race { none, record, check };

struct Request {
  std::filesystem::path file;
  std::vector<std::filesystem::path> folders;  ///< that #include may read, beside the file's own
  std::vector<std::string> kernels;            ///< by name; none: all
  std::vector<std::string> keywords;           ///< chosen ones of multi_compile
  bool fast = false;                           ///< as written, without exactness
  /// Name of the pass of a ShaderToy file, which has mainImage() in place of a kernel: it writes the image
  /// PASS_Output and reads PASS_Channel0 to PASS_Channel3. Empty: none is expected.
  std::string pass;
  bool upsideDown = false;  ///< the first row of PASS_Output is the top one
  /// Notes what an invocation must not do in the block Kernel::report: reads and writes out of bounds (not
  /// when fast) and loops that reach the limit.
  bool report = false;
  unsigned maxIterations = 0;  ///< of a loop, which then ends; 0: no limit
  /// Names of buffers. A kernel that reads and writes one of them reads it as it was before the dispatch,
  /// from a buffer of its own (Buffer::previousOf); atomic operations on it are mistakes.
  std::vector<std::string> previous;
  /// `check` reports races alone, whatever `report` says.
  Race race = Race::none;
};

/// Returns the names of the kernels that a file announces, without compiling them. Throws UserError(usage)
/// for a file that cannot be read.
[[nodiscard]] std::vector<std::string> kernelNames(const Request& request);

/// Compiles the kernels of a file, in a process of its own: compilers are not made for hostile files.
/// Throws UserError(usage) that reports mistakes at file, line and column.
[[nodiscard]] Shader load(const Request& request);
/// The same in this process.
[[nodiscard]] Shader loadHere(const Request& request);

}  // namespace simreel::kernels
