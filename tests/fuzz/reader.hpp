#pragma once
#include <string>
#include <string_view>

namespace simreel::fuzz {

/// What a harness defines: reads the bytes as the program would. A UserError is a refusal, which is fine
/// and has its message checked; anything else that is thrown, and a broken SIMREEL_CHECK, is a finding.
void read(std::string_view bytes);

/// What a harness may define: makes a mutated input whole again where a checksum would end its way at once.
/// May change the length, never beyond `most` bytes.
void mend(std::string& bytes, std::size_t max);

}  // namespace simreel::fuzz
