#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "sim/kernels/memory.hpp"

#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

struct GatherKernel;

/// Words of one buffer or texture of a user's kernels, with the layout of its elements.
struct KernelNumbers {
  const gl::Buffer* words;
  int start, stride, count;
  glm::ivec3 size;
  std::vector<KernelSlot> slots;

  static constexpr const char* chosen = "chosen";  ///< name of the slot if there is only one, because a
                                                   ///< member was chosen
};

/// Entry of a report buffer (layout of KernelReports) in which elements that are not finite are counted.
struct KernelWatch {
  const gl::Buffer* reports = nullptr;  ///< null if elements are not tested
  int place = 0;
};

/// Returns the numbers of the buffer or texture `of`. Call after KernelStore::settle().
[[nodiscard]] KernelNumbers numbersOf(const KernelStore& store, const std::string& of);

/// Returns the numbers of `of` with only one slot, named KernelNumbers::chosen. It holds the first
/// `components` numbers of `member`, or if `member` is empty, of the texel or element.
[[nodiscard]] KernelNumbers numbersOf(const KernelStore& store, const std::string& of,
                                      const std::string& member, std::size_t components);

/// Copies members of the elements of a buffer, or channels of a texture, into an array of vec4.
class KernelGather {
 public:
  KernelGather();
  ~KernelGather();
  KernelGather(const KernelGather&) = delete;
  KernelGather& operator=(const KernelGather&) = delete;

  /// Selection of the numbers to copy. An element without members is a single unnamed slot, which any name
  /// selects.
  struct Chosen {
    std::string member;             ///< slot of the first three numbers
    std::string fourth = {};        ///< slot that gives w; if empty, w of `fill` is used
    std::string alive = {};         ///< slot whose value is above 0 in live elements; w of dead elements
                                    ///< becomes -1
    glm::vec4 fill = glm::vec4(0);  ///< value of numbers that the slots do not have
    bool encoded = false;           ///< true if the first three numbers are sRGB, which become linear
    int components = 3;             ///< number of components that `member` gives
    KernelWatch watch = {};         ///< report entry that counts live elements whose numbers are not finite
    bool marked = true;             ///< if false, `alive` does not change w, and only excludes dead
                                    ///< elements from `watch`
  };
  void run(const KernelNumbers& from, const Chosen& chosen, const gl::Vec4Array& to) const;

 private:
  gl::Kernel<GatherKernel> kernel_;
  gl::Buffer unwatched_;
};

}  // namespace simreel::sim
