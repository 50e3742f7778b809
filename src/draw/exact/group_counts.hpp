#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"

#include <cstddef>

namespace simreel::draw {

/// Arguments of indirect dispatches from counts that kernels have made.
class GroupCounts {
 public:
  static constexpr std::size_t bytes = 4 * sizeof(GLuint);  ///< of a dispatch, one word of it to spare

  struct Order {
    int first = 0;  ///< dispatch to fill
    int firstCount = 0;
    int counts = 1;             ///< how many, from the first count on
    unsigned skipped = 0;       ///< of each count
    unsigned most = ~0U;        ///< taken of each
    unsigned times = 1;         ///< items for one that is counted: fewer than 2^32 together
    unsigned each = 1;          ///< items of a group
    unsigned parts = 1;         ///< groups in the third direction,
    unsigned fewerParts = ~0U;  ///< where less will do not below this
  };
  GroupCounts() : program_(gl::Program::compute("draw/exact/arguments.comp")) {}
  void fill(const gl::Buffer& counts, const Order& order, const gl::Buffer& groups) const;
  /// Runs the program; what has filled the arguments is behind a barrier for commands.
  static void dispatch(const gl::Program& program, const gl::Buffer& groups, std::size_t number);

  /// Kernels that work through lists get groups for what is there on software drivers. On cards, where
  /// filling the arguments costs more than groups that find nothing, they get a fixed number, and go on
  /// with every so manyth entry: there prepareLists does nothing. It stands behind what counts, and before
  /// a barrier of its own.
  void prepareLists(const gl::Buffer& counts, const Order& order, const gl::Buffer& groups) const;
  static void dispatchList(const gl::Program& program, const gl::Buffer& groups, std::size_t number,
                           unsigned parts);
  /// The fixed number of groups, on any device.
  static void dispatchFixed(const gl::Program& program, unsigned parts = 1);

 private:
  gl::Program program_;
};

}  // namespace simreel::draw
