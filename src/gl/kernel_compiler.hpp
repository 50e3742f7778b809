#pragma once
#include "gl/rehearsal.hpp"

#include <vector>

namespace simreel::gl {

class LinkedProgram;

/// Compiles kernels for a software driver on other threads before they are needed. Each thread has a
/// separate context. The machine code reaches the main context through the driver's disk cache. Without a
/// disk cache or on a single processor, this saves no time. At most one object may exist per context.
class KernelCompiler {
 public:
  /// True if compiling in advance can save time: on a software driver with a disk cache and more than one
  /// processor.
  [[nodiscard]] static bool helps();
  /// True if linking a program of this context has taken so long that the program cannot have been in the
  /// driver's cache.
  [[nodiscard]] static bool isCold();
  /// Adds kernels in the order in which they will be needed. Threads start only when the link time of a
  /// program has shown that the driver's cache does not contain the kernels.
  static void announce(std::vector<Rehearsal::Kernel> kernels);
  /// Removes a program from the queue before the main thread links it. If a thread is already compiling the
  /// program, waits for that thread.
  static void claim(const LinkedProgram& program);
  /// Reports the time (s) that linking a program took.
  static void linked(double seconds);
  /// Reports the time (s) of a kernel's first dispatch.
  static void dispatched(double seconds);
  /// Ends the threads, each after its current kernel. The context calls this function before it is
  /// destroyed.
  static void end();
};

}  // namespace simreel::gl
