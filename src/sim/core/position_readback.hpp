#pragma once
#include "gl/buffer.hpp"

#include <array>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Copies an array of vec4 to the CPU asynchronously. Up to three copies are in flight; only wait() blocks.
class PositionReadback {
 public:
  PositionReadback(const std::string& label, std::size_t elements);
  ~PositionReadback();
  PositionReadback(const PositionReadback&) = delete;
  PositionReadback& operator=(const PositionReadback&) = delete;

  /// Collects finished copies, then starts a new copy; skips the new copy if all three slots are still in
  /// flight.
  void start(const gl::Buffer& source);
  /// Returns the newest finished copy; empty before the first one.
  [[nodiscard]] const std::vector<glm::vec4>& newest();
  /// Returns true if the latest start() began a copy.
  [[nodiscard]] bool current() const { return current_; }
  /// Waits for all copies in flight and returns the newest.
  [[nodiscard]] const std::vector<glm::vec4>& wait();

 private:
  bool takeOldest(bool waiting);
  struct Slot {
    gl::Buffer buffer;
    GLsync done = nullptr;
  };
  std::array<Slot, 3> slots_;
  std::size_t oldest_ = 0;
  std::size_t count_ = 0;
  bool current_ = false;
  std::vector<glm::vec4> newest_;
};

/// If the fence is signalled, deletes it, sets it to null and returns true. If `waiting` is true, blocks
/// until the fence is signalled; otherwise only polls.
bool pollFence(GLsync& fence, bool waiting);

}  // namespace simreel::sim
