#pragma once
#include <string>
#include <string_view>

namespace simreel::fuzz {

/// A harness that tests one reader of the program with damaged bytes. Each harness is a constant of its
/// source file.
struct Reader {
  /// Reads the bytes as the program would. A UserError is a valid refusal, whose message is then checked.
  /// Any other exception, or a failed SIMREEL_CHECK, is a finding.
  using Read = void (*)(std::string_view bytes);
  /// Repairs the checksum of a mutated input, so that the reader accepts the checksum. Must not make the
  /// input longer.
  using Mend = void (*)(std::string& bytes);

  /// Registers this harness under `name` for `--reader=NAME`.
  Reader(const char* name, Read read, Mend mend = nullptr);

  const char* name;
  Read read;
  Mend mend;
  const Reader* next;  // next harness in the list of all harnesses
};

}  // namespace simreel::fuzz
