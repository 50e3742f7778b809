#include "plain.hpp"

#include <cstring>

namespace plain {

namespace {

using Eight = float __attribute__((vector_size(32)));
volatile float sink;

// Ten independent chains of operations hide the latency of each operation. Multiplication and addition are
// separate instructions, as in exact mode, which does not use FMA.
#if defined(__x86_64__)
__attribute__((target("avx2")))
#endif
void chains(Eight* sums, int rounds) {
  const Eight factor = Eight{} + 0.999F, term = Eight{} + 0.001F;
  Eight s[10];
  for (int k = 0; k < 10; ++k) s[k] = sums[k];
  for (int i = 0; i < rounds; ++i)
    for (int k = 0; k < 10; ++k) s[k] = s[k] * factor + term;
  for (int k = 0; k < 10; ++k) sums[k] = s[k];
}

}  // namespace

double arithmetic() {
  constexpr int rounds = 2'000'000;
  Eight sums[10] = {};
#if defined(__x86_64__)
  if (!__builtin_cpu_supports("avx2")) {  // Without AVX2, there are four lanes instead of eight.
    float four[40] = {};
    for (int i = 0; i < rounds; ++i)
      for (float& s : four) s = s * 0.999F + 0.001F;
    sink = four[0];
    return 80.0 * rounds;
  }
#endif
  chains(sums, rounds);
  sink = sums[3][1];
  return 160.0 * rounds;
}

double copying(std::size_t bytes) {
  static std::vector<char> from, to;
  from.resize(bytes / 2 + 1, 1);
  to.resize(from.size());
  double copied = 0;
  for (; copied < 1e8; copied += 2.0 * static_cast<double>(from.size())) {
    std::memcpy(to.data(), from.data(), from.size());
    sink = to[from.size() / 3];
  }
  return copied;
}

}  // namespace plain
