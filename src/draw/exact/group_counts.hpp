#pragma once
#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "gl/kernel/kernel.hpp"

#include <cstddef>
#include <type_traits>
#include <variant>

namespace simreel::draw {

/// Arguments of indirect dispatches from counts that kernels have made.
class GroupCounts {
 public:
  static constexpr std::size_t bytes = 4 * sizeof(GLuint);  ///< of a dispatch, one word of it to spare

  struct Order {
    gl::Uniform<"first", int> first = 0;  ///< dispatch to fill
    gl::Uniform<"firstCount", int> firstCount = 0;
    gl::Uniform<"counts", int> counts = 1;          ///< how many, from the first count on
    gl::Uniform<"skipped", unsigned> skipped = 0U;  ///< of each count
    gl::Uniform<"most", unsigned> most = ~0U;       ///< taken of each
    gl::Uniform<"times", unsigned> times = 1U;  ///< items for one that is counted: fewer than 2^32 together
    gl::Uniform<"each", unsigned> each = 1U;    ///< items of a group
    gl::Uniform<"parts", unsigned> parts = 1U;  ///< groups in the third direction,
    gl::Uniform<"fewerParts", unsigned> fewerParts = ~0U;  ///< where less will do not below this
  };
  struct Arguments {
    static constexpr auto file = "draw/exact/arguments.comp";
    Order order;
    gl::In<"counters"> counters;
    gl::Shared<"groups"> groups;
  };
  void fill(const gl::Buffer& counts, const Order& order, const gl::Buffer& groups) const;
  template <class Interface>
  static void dispatch(const gl::Kernel<Interface>& kernel, const gl::Buffer& groups, std::size_t number,
                       const std::type_identity_t<Interface>& given) {
    kernel.dispatchIndirect(groups, number * bytes, given);
  }

  /// Kernels that work through lists get groups for what is there on software drivers. On cards, where
  /// filling the arguments costs more than groups that find nothing, they get a fixed number, and go on
  /// with every so manyth entry: there prepareLists does nothing.
  void prepareLists(const gl::Buffer& counts, const Order& order, const gl::Buffer& groups) const;
  template <class Interface>
  static void dispatchList(const gl::Kernel<Interface>& kernel, const gl::Buffer& groups,
                           std::size_t number, unsigned parts,
                           const std::type_identity_t<Interface>& given) {
    if (!gl::softwareDriver()) return dispatchFixed(kernel, parts, given);
    dispatch(kernel, groups, number, given);
  }
  /// The fixed number of groups, on any device.
  template <class Interface>
  static void dispatchFixed(const gl::Kernel<Interface>& kernel, unsigned parts,
                            const std::type_identity_t<Interface>& given) {
    kernel.dispatchGroups({fixedGroups(parts), 1U, parts}, given);
  }

 private:
  static unsigned fixedGroups(unsigned parts);

  gl::Kernel<Arguments> kernel_{gl::Defines()};
};

}  // namespace simreel::draw
