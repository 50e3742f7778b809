#pragma once
#include "gl/buffer.hpp"

#include <array>
#include <string>
#include <vector>

#include <epoxy/gl.h>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Copies an array of vec4 to the CPU behind the GPU's back: up to three copies are under way, and nothing
/// waits unless it is asked to.
class PositionReadback {
 public:
  PositionReadback(const std::string& label, std::size_t elements);
  ~PositionReadback();
  PositionReadback(const PositionReadback&) = delete;
  PositionReadback& operator=(const PositionReadback&) = delete;

  /// Takes what has arrived, then starts a copy; does without it when all three are still under way.
  void start(const gl::Buffer& source);
  /// The newest copy that has arrived; empty before the first.
  [[nodiscard]] const std::vector<glm::vec4>& newest();
  /// Whether the latest start() began a copy.
  [[nodiscard]] bool current() const { return current_; }
  /// Waits for the copies under way, then as newest().
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

/// Deletes a fence that was reached and makes it null; without `waiting` it only looks. Whether it was
/// reached.
bool takeFence(GLsync& fence, bool waiting);

}  // namespace simreel::sim
