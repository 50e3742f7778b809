#pragma once
#include <string>
#include <string_view>

namespace simreel::fuzz {

/// What a harness defines, once, as a constant of its file: how a reader of the program meets damaged
/// bytes.
struct Reader {
  /// Reads the bytes as the program would. A UserError is a refusal, which is fine and has its message
  /// checked; anything else that is thrown, and a broken SIMREEL_CHECK, is a finding.
  using Read = void (*)(std::string_view bytes);
  /// Makes a mutated input whole again where a checksum would end its way at once; never makes it longer.
  using Mend = void (*)(std::string& bytes);

  /// From here on `--reader=NAME` means this one.
  Reader(const char* name, Read read, Mend mend = nullptr);

  const char* name;
  Read read;
  Mend mend;
  const Reader* next;  // of those there are, in no order
};

}  // namespace simreel::fuzz
