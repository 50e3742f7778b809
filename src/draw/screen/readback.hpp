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

/// Copies finished pictures to the CPU while later frames are drawn. With a card, what has come into memory
/// that the card can write is copied on by a thread of its own: the one that issues frames has no time to.
class Readback {
 public:
  static constexpr std::size_t maxUnderWay = 3;

  explicit Readback(glm::ivec2 size);
  ~Readback();
  Readback(Readback&&) = delete;
  Readback& operator=(Readback&&) = delete;
  Readback(const Readback&) = delete;
  Readback& operator=(const Readback&) = delete;

  /// Starts copying the framebuffer's RGBA8 pixels. Call take() first when full.
  void start(const gl::Framebuffer& framebuffer, int tag);
  [[nodiscard]] bool full() const { return count_ == slots_.size(); }
  [[nodiscard]] bool empty() const { return count_ == 0; }
  /// Blocks until the oldest copy is complete, so that take() only copies.
  void waitForOldest() const { static_cast<void>(reached(true)); }
  /// The oldest picture, in the order of start(): its tag and width * height * 4 bytes, row 0 of the
  /// framebuffer first. Nothing when none is under way or, unless `wait`, when it is not there yet.
  [[nodiscard]] std::optional<std::pair<int, std::vector<std::uint8_t>>> take(bool wait);

 private:
  [[nodiscard]] bool reached(bool wait) const;
  struct Slot {
    gl::Handle<gl::DeleteBuffer> buffer;
    const std::uint8_t* bytes = nullptr;  ///< mapped for the slot's whole life
    GLsync done = nullptr;
    int tag = 0;
    CopyThread::Task copy;
    bool copies = false;  ///< the thread is at it
  };
  /// Whether the picture has come; `wait` until it has.
  static bool isThere(const Slot& slot, bool wait);
  void copyOn();

  glm::ivec2 size_;
  std::size_t bytes_;
  std::array<Slot, maxUnderWay> slots_;
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  CopyThread thread_;  ///< ends before the memory that it reads
};

}  // namespace simreel::draw
