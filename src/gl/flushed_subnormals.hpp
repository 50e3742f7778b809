#pragma once
#include <cstdint>

#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

namespace simreel::gl {

/// Makes this thread treat subnormal numbers as zero while the object exists. Threads that a software
/// driver starts meanwhile keep this mode, so that its kernels treat subnormal numbers as graphics cards
/// do. Has no effect on processors other than x86-64 and 64-bit Arm.
class FlushedSubnormals {
 public:
  FlushedSubnormals() : before_(mode()) { setMode(before_ | flushes); }
  ~FlushedSubnormals() { setMode(before_); }
  FlushedSubnormals(const FlushedSubnormals&) = delete;
  FlushedSubnormals& operator=(const FlushedSubnormals&) = delete;

 private:
#if defined(__x86_64__)
  static constexpr std::uint64_t flushes =
      0x8040;  // results (FTZ, bit 15) and operands (DAZ, bit 6) of MXCSR
  static std::uint64_t mode() {
    return _mm_getcsr();
  }
  static void setMode(std::uint64_t mode) {
    _mm_setcsr(static_cast<unsigned>(mode));
  }
#elif defined(__aarch64__)
  static constexpr std::uint64_t flushes = 1U << 24U;  // FZ of FPCR
  static std::uint64_t mode() {
    std::uint64_t value = 0;
    asm volatile("mrs %0, fpcr" : "=r"(value));
    return value;
  }
  static void setMode(std::uint64_t mode) {
    asm volatile("msr fpcr, %0" : : "r"(mode));
  }
#else
  static constexpr std::uint64_t flushes = 0;
  static std::uint64_t mode() {
    return 0;
  }
  static void setMode(std::uint64_t) {}
#endif

  std::uint64_t before_;
};

}  // namespace simreel::gl
