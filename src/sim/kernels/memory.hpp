#pragma once
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/program.hpp"
#include "sim/kernels/plan.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace simreel::sim {

/// Maximum number of invocations of one dispatch over the elements of a buffer, because some drivers allow
/// only 65,535 groups. A group has 64 invocations.
inline constexpr int maxThreads = 65535 * 64;

struct CanonicalKernel;
struct TexelCopy;

/// Owns the buffers and textures of a user's kernels on the GPU.
class KernelStore {
 public:
  /// Throws UserError(device) if the memory exceeds a limit of the device.
  KernelStore(const std::string& name, const KernelPlan& plan, unsigned seed);
  ~KernelStore();
  KernelStore(const KernelStore&) = delete;
  KernelStore& operator=(const KernelStore&) = delete;

  /// Binds the buffers and textures of a kernel.
  void bind(const kernels::Kernel& kernel);
  void swap(const std::string& a, const std::string& b);
  void clear(const std::string& name);
  /// Copies a buffer's counter into another buffer.
  void copyCounter(const PlannedEntry& entry);
  /// Copy of all memory.
  struct Saved {
    std::vector<gl::Buffer> buffers, words;
  };
  [[nodiscard]] Saved save();
  void restore(const Saved& saved);
  /// Clears the guard elements that absorb out-of-bounds writes, replaces NaNs by a canonical NaN (machines
  /// differ in its sign and payload), and copies textures into words(). Call it before reading the state.
  void settle();
  /// Fills the textures from words() after words() has been restored.
  void putBack();

  [[nodiscard]] const gl::Buffer& buffer(int place) const {
    return buffers_[static_cast<std::size_t>(place)];
  }
  [[nodiscard]] gl::Buffer& buffer(int place) { return buffers_[static_cast<std::size_t>(place)]; }
  /// Returns the texels of a texture as copied by settle(), four words per texel.
  [[nodiscard]] const gl::Buffer& words(int texture) const {
    return words_[static_cast<std::size_t>(texture)].buffer();
  }
  [[nodiscard]] gl::Buffer& words(int texture) {
    return words_[static_cast<std::size_t>(texture)].buffer();
  }
  /// Returns the array that words() gives access to, with its views.
  [[nodiscard]] gl::WordsArray& texels(std::size_t texture) { return words_[texture]; }
  /// Fills one texture from words().
  void putBackOne(std::size_t texture);
  [[nodiscard]] const KernelPlan& plan() const { return plan_; }

 private:
  void makeTexture(const std::string& name, const PlannedTexture& planned, unsigned seed);
  void putBack(std::size_t texture);
  void keepPrevious(int copy, int original);

  const KernelPlan& plan_;
  std::vector<gl::Buffer> buffers_, floats_;
  gl::Kernel<CanonicalKernel> canonical_;
  std::vector<gl::Texture> textures_;
  std::vector<gl::WordsArray> words_;
  std::vector<gl::Kernel<TexelCopy>> copies_;
};

}  // namespace simreel::sim
