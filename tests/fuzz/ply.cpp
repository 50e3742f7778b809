#include "fuzz/particles.hpp"
#include "fuzz/reader.hpp"

namespace simreel::fuzz {
namespace {

void readPly(std::string_view bytes) {
  if (bytes.starts_with("ply")) readCloud(bytes, "fuzz.ply");
}

const Reader plyReader("ply", readPly);

}  // namespace
}  // namespace simreel::fuzz
