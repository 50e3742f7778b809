#pragma once
// Time of each kernel on the device, by timer queries around every direct dispatch.
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

namespace simreel::bench {

/// Measures the dispatches between its construction and its destruction. One object at a time.
class DispatchTimes {
 public:
  struct Sum {
    int dispatches = 0;
    double seconds = 0;
  };

  DispatchTimes() {
    current() = this;
    original() = std::exchange(epoxy_glDispatchCompute, &measured);
  }
  ~DispatchTimes() {
    epoxy_glDispatchCompute = original();
    current() = nullptr;
    for (const Dispatch& one : dispatches_) glDeleteQueries(2, one.queries);
  }
  DispatchTimes(const DispatchTimes&) = delete;
  DispatchTimes& operator=(const DispatchTimes&) = delete;

  /// Waits for the device and returns the sums by the labels of the programs.
  [[nodiscard]] std::map<std::string, Sum> sums() const {
    std::map<std::string, Sum> all;
    for (const Dispatch& one : dispatches_) {
      GLuint64 begin = 0, end = 0;
      glGetQueryObjectui64v(one.queries[0], GL_QUERY_RESULT, &begin);
      glGetQueryObjectui64v(one.queries[1], GL_QUERY_RESULT, &end);
      char label[256] = {};
      glGetObjectLabel(GL_PROGRAM, one.program, sizeof label, nullptr, label);
      Sum& sum = all[label];
      ++sum.dispatches;
      sum.seconds += static_cast<double>(end - begin) * 1e-9;
    }
    return all;
  }

 private:
  struct Dispatch {
    GLuint program = 0, queries[2] = {};
  };

  static DispatchTimes*& current() {
    static DispatchTimes* object = nullptr;
    return object;
  }
  static PFNGLDISPATCHCOMPUTEPROC& original() {
    static PFNGLDISPATCHCOMPUTEPROC function = nullptr;
    return function;
  }
  static void EPOXY_CALLSPEC measured(GLuint x, GLuint y, GLuint z) {
    Dispatch one;
    GLint program = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    one.program = static_cast<GLuint>(program);
    glCreateQueries(GL_TIMESTAMP, 2, one.queries);
    glQueryCounter(one.queries[0], GL_TIMESTAMP);
    original()(x, y, z);
    glQueryCounter(one.queries[1], GL_TIMESTAMP);
    current()->dispatches_.push_back(one);
  }

  std::vector<Dispatch> dispatches_;
};

}  // namespace simreel::bench
