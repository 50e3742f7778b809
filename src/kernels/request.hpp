#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace simreel::kernels {

/// Step of the search for races. A dispatch runs twice from the same state. `record` stores in shadow
/// buffers which invocation changed each word (Buffer::shadowOf). `check` compares each access with the
/// shadows.
enum class Race { none, record, check };

struct Request {
  std::filesystem::path file;
  std::vector<std::filesystem::path> folders;  ///< folders for #include, in addition to the file's folder
  std::vector<std::string> kernels;            ///< names of the selected kernels; if empty, all kernels are
                                               ///< selected
  std::vector<std::string> keywords;           ///< selected keywords of multi_compile
  bool fast = false;                           ///< true to compile the shader as written, without exact
                                               ///< operations
  /// True to flush subnormal numbers, divide and take roots in integers, for drivers whose arithmetic
  /// differs (sim/kernels/arithmetic.hpp). The results have the same bits.
  bool careful = false;
  /// Name of the pass for a ShaderToy file, which has mainImage() instead of a kernel. The pass writes the
  /// image PASS_Output and reads PASS_Channel0 to PASS_Channel3. Empty for other files.
  std::string pass;
  bool upsideDown = false;  ///< true if the first row of PASS_Output is the top row
  /// True to record faults in the block Kernel::report: out-of-bounds reads and writes (unless `fast`), and
  /// loops that reach the limit.
  bool report = false;
  unsigned maxIterations = 0;  ///< max iterations of a loop, after which it is stopped; 0 means no limit
  /// Names of buffers whose reads are redirected. A kernel that both reads and writes such a buffer reads
  /// the state from before the dispatch, from a separate buffer (Buffer::previousOf). Atomic operations on
  /// it are errors.
  std::vector<std::string> previous;
  /// Search for races. `check` reports only races, regardless of `report`.
  Race race = Race::none;
};

}  // namespace simreel::kernels
