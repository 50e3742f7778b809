#include "fuzz/particles.hpp"
#include "fuzz/reader.hpp"

namespace simreel::fuzz {
namespace {

void readCsv(std::string_view bytes) {
  if (!bytes.starts_with("ply")) readCloud(bytes, "fuzz.csv");
}

const Reader csvReader("csv", readCsv);

}  // namespace
}  // namespace simreel::fuzz
