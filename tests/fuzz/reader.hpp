#pragma once
#include <string>
#include <string_view>

namespace simreel::fuzz {

/// A harness, defined once as a constant of its file: tests one reader of the program with damaged bytes.
struct Reader {
  /// Reads the bytes as the program would. A UserError is a valid refusal, and its message is checked. Any
  /// other exception, or a failed SIMREEL_CHECK, is a finding.
  using Read = void (*)(std::string_view bytes);
  /// Repairs the checksum of a mutated input, so that the reader gets past it; never makes the input
  /// longer.
  using Mend = void (*)(std::string& bytes);

  /// Registers this harness under `name` for `--reader=NAME`.
  Reader(const char* name, Read read, Mend mend = nullptr);

  const char* name;
  Read read;
  Mend mend;
  const Reader* next;  // next harness in the list of all harnesses
};

}  // namespace simreel::fuzz
