#pragma once
#include "gl/rehearsal.hpp"

#include <vector>

namespace simreel::gl {

class LinkedProgram;

/// Has a software driver compile kernels on other threads before they are needed. Machine code belongs to
/// one context and reaches another one through the driver's cache on disk: there is nothing to gain without
/// such a cache, or on a single processor. One for each context at most.
class KernelCompiler {
 public:
  /// True if compiling ahead can help: a software driver with a cache on disk, and an idle processor.
  [[nodiscard]] static bool helps();
  /// True once a program of this context took too long to come from the driver's cache.
  [[nodiscard]] static bool isCold();
  /// Announces kernels in the order in which they will be needed. Threads start once linking any program
  /// has shown that the driver's cache is not filled.
  static void announce(std::vector<Rehearsal::Kernel> kernels);
  /// Call before linking: waits where a thread is at it, and keeps the threads from it otherwise.
  static void claim(const LinkedProgram& program);
  /// Takes the seconds that linking a program took.
  static void linked(double seconds);
  /// Takes the seconds of a kernel's first dispatch.
  static void dispatched(double seconds);
  /// Ends the threads, each after the kernel that it is at. The context calls it before it ends.
  static void end();
};

}  // namespace simreel::gl
