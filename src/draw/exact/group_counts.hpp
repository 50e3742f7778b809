#pragma once
#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "gl/kernel/kernel.hpp"

#include <cstddef>
#include <type_traits>
#include <variant>

namespace simreel::draw {

/// Computes the arguments of indirect dispatches on the GPU (draw/exact/arguments.comp) from item counts
/// that kernels have written.
class GroupCounts {
 public:
  static constexpr std::size_t bytes = 4 * sizeof(GLuint);  ///< bytes per dispatch: three arguments and an
                                                            ///< unused word

  struct CountConversion {
    gl::Uniform<"first", int> first = 0;  ///< index of the first dispatch to fill
    gl::Uniform<"firstCount", int> firstCount = 0;
    gl::Uniform<"counts", int> counts = 1;          ///< number of counts to convert, starting at firstCount
    gl::Uniform<"skipped", unsigned> skipped = 0U;  ///< number of items to subtract from each count
    gl::Uniform<"maximum", unsigned> maximum = ~0U;  ///< max number of items that a dispatch processes
    gl::Uniform<"times", unsigned> times = 1U;  ///< factor of each count; the product must be below 2^32
    gl::Uniform<"each", unsigned> each = 1U;    ///< items per workgroup
    gl::Uniform<"parts", unsigned> parts = 1U;  ///< workgroups in the third dimension
    gl::Uniform<"minGroupsZ", unsigned> minGroupsZ = ~0U;  ///< min number of workgroups in the third
                                                           ///< dimension if there are many items
  };
  struct Arguments {
    static constexpr auto file = "draw/exact/arguments.comp";
    CountConversion order;
    gl::In<"counters"> counters;
    gl::Shared<"groups"> groups;
  };
  void fill(const gl::Buffer& counts, const CountConversion& order, const gl::Buffer& groups) const;
  template <class Interface>
  static void dispatch(const gl::Kernel<Interface>& kernel, const gl::Buffer& groups, std::size_t number,
                       const std::type_identity_t<Interface>& given) {
    kernel.dispatchIndirect(groups, number * bytes, given);
  }

  /// Fills the arguments of kernels that process lists, on software drivers only. On GPUs, idle workgroups
  /// cost less than filling the arguments, so dispatchList() uses a fixed number of workgroups that stride
  /// through the list.
  void prepareLists(const gl::Buffer& counts, const CountConversion& order, const gl::Buffer& groups) const;
  template <class Interface>
  static void dispatchList(const gl::Kernel<Interface>& kernel, const gl::Buffer& groups,
                           std::size_t number, unsigned parts,
                           const std::type_identity_t<Interface>& given) {
    if (!gl::softwareDriver()) return dispatchFixed(kernel, parts, given);
    dispatch(kernel, groups, number, given);
  }
  /// Dispatches a fixed number of workgroups on any device.
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
