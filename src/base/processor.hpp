#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace simreel {

/// "AMD EPYC 7B13, family 25 model 1 stepping 0, sse4_1 avx f16c fma avx2": the processor by name, since
/// clouds give several kinds one name also by its numbers, and those of its instruction sets for which
/// software drivers make other code (a virtual machine may hide some). "unknown x86_64" where nothing is
/// known.
[[nodiscard]] std::string processorName();

/// The same as processorName() from the text of /proc/cpuinfo, of its first processor.
[[nodiscard]] std::string processorName(std::string_view cpuinfo, const std::string& architecture);

/// How many processors this process may run on (taskset, containers' sets of processors), at least 1.
[[nodiscard]] std::size_t processorCount();

}  // namespace simreel
