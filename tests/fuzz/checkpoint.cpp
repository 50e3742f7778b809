#include "frame/checkpoint.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "fuzz/reader.hpp"
#include "fuzz/scratch.hpp"

using namespace simreel;

namespace {

/// The run that the seeds are of.
frame::RunInfo run() {
  return {.title = "t",
          .sceneHash = "s",
          .seed = 1,
          .width = 8,
          .height = 8,
          .fps = 60,
          .numerics = "exact",
          .fingerprint = "f",
          .driver = "d"};
}

}  // namespace

/// The payload's hash, in the header.
void simreel::fuzz::mend(std::string& bytes, std::size_t /*most*/) {
  constexpr std::string_view key = "\"hash\":\"";
  const std::size_t line = bytes.find('\n');
  const std::size_t at = bytes.find(key);
  if (line == std::string::npos || at == std::string::npos || at + key.size() + 32 > line) return;
  bytes.replace(at + key.size(), 32, hashHex(std::string_view(bytes).substr(line + 1)));
}

void simreel::fuzz::read(std::string_view bytes) {
  const auto file = scratchFolder() / "checkpoint";
  writeFileAtomically(file, bytes);
  const auto checkpoint = frame::Checkpoint::read(file, run());
  if (!checkpoint) return;
  SIMREEL_CHECK(checkpoint->frame() >= 0);
  SIMREEL_CHECK(checkpoint->counts().size() <= bytes.size());
}
