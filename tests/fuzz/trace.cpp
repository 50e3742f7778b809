// Fuzzes the reader of steps.bin. An accepted file must be written as the same bytes.
#include "golden/trace/trace.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "fuzz/reader.hpp"
#include "golden/trace/file.hpp"
#include "golden/trace/layout.hpp"

#include <algorithm>

namespace simreel::fuzz {
namespace {

/// Updates the hash at the end of a mutated file.
void mendTrace(std::string& bytes) {
  if (bytes.size() < hashDigits) return;
  const std::string hash = hashHex(std::string_view(bytes).substr(0, bytes.size() - hashDigits));
  bytes.replace(bytes.size() - hashDigits, hashDigits, hash);
}

void readTrace(std::string_view bytes) {
  const auto file = std::as_bytes(std::span(bytes.data(), bytes.size()));
  const golden::StepTrace trace = golden::decodeTrace(file, "steps.bin");
  const auto written = golden::encodeTrace(trace);
  SIMREEL_CHECK(std::equal(written.begin(), written.end(), file.begin(), file.end()));
  SIMREEL_CHECK(!golden::compareTraces(trace, trace));
  const golden::StepTrace last = golden::reduced(trace, true, 0);
  SIMREEL_CHECK_EQ(last.words.size(), last.totalWords());
}

const Reader traceReader("trace", readTrace, mendTrace);

}  // namespace
}  // namespace simreel::fuzz
