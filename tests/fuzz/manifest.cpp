#include "frame/file/manifest.hpp"

#include "base/error.hpp"
#include "fuzz/reader.hpp"

void simreel::fuzz::read(std::string_view bytes) {
  const frame::Manifest manifest = frame::parseManifest(std::string(bytes), "manifest.json");
  const std::string text = frame::manifestText(manifest);
  const frame::Manifest again = frame::parseManifest(text, "again.json");
  SIMREEL_CHECK_EQ(frame::manifestText(again), text);
  SIMREEL_CHECK(!frame::runDifference(again.run, manifest.run));
}
