#pragma once
#include "gl/handle.hpp"

namespace simreel::gl {

/// A moment on the device's clock: when everything issued before record() was done. Unlike TimerQuery these
/// may lie between and inside each other.
class Timestamp {
 public:
  Timestamp() : handle_(create()) {}
  void record() { glQueryCounter(handle_.get(), GL_TIMESTAMP); }
  /// Milliseconds since `earlier`. Waits for both.
  [[nodiscard]] double millisecondsSince(const Timestamp& earlier) const {
    return static_cast<double>(nanoseconds() - earlier.nanoseconds()) * 1e-6;
  }

 private:
  static GLuint create() {
    GLuint name = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &name);
    return name;
  }
  [[nodiscard]] GLint64 nanoseconds() const {
    GLint64 result = 0;
    glGetQueryObjecti64v(handle_.get(), GL_QUERY_RESULT, &result);
    return result;
  }
  Handle<DeleteQuery> handle_;
};

}  // namespace simreel::gl
