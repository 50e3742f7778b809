#include "base/processor.hpp"

#include <doctest/doctest.h>

using simreel::processorName;

TEST_CASE("a processor is described by model, core counts and instruction sets") {
  const char* intel =
      "processor\t: 0\nvendor_id\t: GenuineIntel\ncpu family\t: 6\nmodel\t\t: 85\n"
      "model name\t: Intel(R) Xeon(R) Processor @ 2.00GHz\nstepping\t: 7\nflags\t\t: fpu sse4_1 avx avx2 "
      "fma\n\n"
      "processor\t: 1\nmodel name\t: another\nflags\t: avx512f\n";
  CHECK(processorName(intel, "x86_64") ==
        "Intel(R) Xeon(R) Processor @ 2.00GHz, family 6 model 85 stepping 7, sse4_1 avx fma avx2");
  const char* arm =
      "processor\t: 0\nBogoMIPS\t: 50.00\nFeatures\t: fp asimd sve\nCPU implementer\t: 0x41\n"
      "CPU architecture: 8\nCPU variant\t: 0x1\nCPU part\t: 0xd40\nCPU revision\t: 1\n";
  CHECK(processorName(arm, "aarch64") == "implementer 0x41 part 0xd40 variant 0x1 revision 1, sve");
  CHECK(processorName("", "riscv64") == "unknown riscv64");
  CHECK(processorName("model name", "x86_64") == "unknown x86_64");
  CHECK(processorName("model name :", "x86_64") == "unknown x86_64");
  CHECK(!processorName().empty());
  CHECK(processorName() == processorName());
}
