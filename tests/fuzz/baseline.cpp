// Fuzzes the readers of baseline.json and state.json.
#include "golden/baseline/baseline.hpp"

#include "base/error.hpp"
#include "fuzz/reader.hpp"

namespace simreel::fuzz {
namespace {

void readBaseline(std::string_view bytes) {
  const std::string text(bytes);
  try {
    const std::string written = golden::picturesText(golden::parsePictures(text, "baseline.json"));
    SIMREEL_CHECK_EQ(golden::picturesText(golden::parsePictures(written, "again.json")), written);
    return;
  } catch (const UserError&) {  // Bytes that are not a baseline are read as a state.
  }
  const std::string written = golden::stateText(golden::parseState(text, "state.json"));
  SIMREEL_CHECK_EQ(golden::stateText(golden::parseState(written, "again.json")), written);
}

const Reader baselineReader("baseline", readBaseline);

}  // namespace
}  // namespace simreel::fuzz
