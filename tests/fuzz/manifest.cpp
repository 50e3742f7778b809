#include "frame/file/manifest.hpp"

#include "base/error.hpp"
#include "fuzz/reader.hpp"

namespace simreel::fuzz {
namespace {

void readManifest(std::string_view bytes) {
  const frame::Manifest manifest = frame::parseManifest(std::string(bytes), "manifest.json");
  const std::string text = frame::manifestText(manifest);
  const frame::Manifest again = frame::parseManifest(text, "again.json");
  SIMREEL_CHECK_EQ(frame::manifestText(again), text);
  SIMREEL_CHECK(!frame::runDifference(again.run, manifest.run));
}

const Reader manifestReader("manifest", readManifest);

}  // namespace
}  // namespace simreel::fuzz
