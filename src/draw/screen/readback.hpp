#pragma once
#include "draw/screen/copy_thread.hpp"
#include "gl/handle.hpp"
#include "gl/texture.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Copies finished pictures to the CPU while later frames are drawn. With a GPU, a separate thread copies
/// the pictures out of the mapped memory, because the thread that issues frames has no time for it.
class Readback {
 public:
  static constexpr std::size_t maxUnderWay = 3;

  explicit Readback(glm::ivec2 size);
  ~Readback();
  Readback(Readback&&) = delete;
  Readback& operator=(Readback&&) = delete;
  Readback(const Readback&) = delete;
  Readback& operator=(const Readback&) = delete;

  /// Starts to copy the framebuffer's RGBA8 pixels. If full() is true, call nextPicture() first.
  void start(const gl::Framebuffer& framebuffer, int tag);
  [[nodiscard]] bool full() const { return count_ == slots_.size(); }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Blocks until the oldest copy is complete, so that nextPicture() does not wait for the GPU.
  void waitForOldest() const { static_cast<void>(reached(true)); }
  /// Returns the oldest picture, in the order of start(): its tag and its bytes (width * height * 4,
  /// starting with row 0 of the framebuffer). Returns nothing if no copy is in progress, or if the oldest
  /// copy is not complete and `wait` is false.
  [[nodiscard]] std::optional<std::pair<int, std::vector<std::uint8_t>>> nextPicture(bool wait);

 private:
  [[nodiscard]] bool reached(bool wait) const;
  struct Slot {
    gl::Handle<gl::DeleteBuffer> buffer;
    const std::uint8_t* bytes = nullptr;  ///< memory that is mapped during the slot's whole lifetime
    GLsync done = nullptr;
    int tag = 0;
    CopyThread::Task copy;
    bool copies = false;  ///< true while the thread copies the slot's picture
  };
  /// True if the GPU has finished the slot's copy. With `wait`, waits for the copy.
  static bool isReady(const Slot& slot, bool wait);
  void copyOn();

  glm::ivec2 size_;
  std::size_t bytes_;
  std::array<Slot, maxUnderWay> slots_;
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  CopyThread thread_;  ///< last member, so that its destructor runs before the memory is released
};

}  // namespace simreel::draw
