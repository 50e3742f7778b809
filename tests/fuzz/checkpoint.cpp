#include "frame/file/checkpoint.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/hash.hpp"
#include "frame/file/run_info.hpp"
#include "fuzz/reader.hpp"
#include "fuzz/scratch.hpp"

namespace simreel::fuzz {
namespace {

/// Returns the run information that the seed files contain.
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

/// Updates the hash at the end of the bytes. It covers all bytes before it.
void mendCheckpoint(std::string& bytes) {
  if (bytes.size() < hashDigits) return;
  const std::size_t body = bytes.size() - hashDigits;
  bytes.replace(body, hashDigits, hashHex(std::string_view(bytes).substr(0, body)));
}

void readCheckpoint(std::string_view bytes) {
  const auto file = scratchFolder() / "checkpoint";
  writeFileAtomically(file, bytes);
  const auto checkpoint = frame::Checkpoint::read(file, run(), 500);
  if (!checkpoint) return;
  SIMREEL_CHECK(checkpoint->frame() >= 0 && checkpoint->frame() <= 500);
  SIMREEL_CHECK(checkpoint->counts().size() <= bytes.size());
}

const Reader checkpointReader("checkpoint", readCheckpoint, mendCheckpoint);

}  // namespace
}  // namespace simreel::fuzz
