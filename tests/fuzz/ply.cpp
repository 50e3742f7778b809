#include "fuzz/particles.hpp"
#include "fuzz/reader.hpp"

void simreel::fuzz::read(std::string_view bytes) {
  if (bytes.starts_with("ply")) readCloud(bytes, "fuzz.ply");
}
