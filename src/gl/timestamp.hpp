#pragma once
#include "gl/handle.hpp"

namespace simreel::gl {

/// A point in time on the device's clock, at which all commands issued before record() are complete.
/// Intervals between timestamps may overlap and nest, unlike the intervals of TimerQuery.
class Timestamp {
 public:
  Timestamp() : handle_(create()) {}
  void record() { glQueryCounter(handle_.get(), GL_TIMESTAMP); }
  /// Returns the time since `earlier` (ms). Waits for both timestamps.
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
