#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace simreel {

/// Returns a description of the processor: "AMD EPYC 7B13, family 25 model 1 stepping 0, sse4_1 avx f16c
/// fma avx2". The numbers distinguish processors to which clouds give the same name. The listed instruction
/// sets are the ones for which software drivers generate different code. A virtual machine may hide some of
/// them. Returns "unknown x86_64" if nothing is known.
[[nodiscard]] std::string processorName();

/// Does the same as processorName() for a given text of /proc/cpuinfo. Uses the first processor in it.
[[nodiscard]] std::string processorName(std::string_view cpuinfo, const std::string& architecture);

/// Returns the number of processors that this process may run on (taskset, CPU sets of containers), at
/// least 1.
[[nodiscard]] std::size_t processorCount();

}  // namespace simreel
