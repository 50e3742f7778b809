// What libFuzzer calls; every harness is linked with it.
#include "base/error.hpp"
#include "base/log.hpp"
#include "fuzz/reader.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>

using namespace simreel;

// What a harness writes need not outlast a power cut: waiting for the disk would take nearly all of the
// time.
extern "C" int fsync(int /*descriptor*/) {
  return 0;
}
extern "C" int fdatasync(int /*descriptor*/) {
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);

namespace simreel::fuzz {

[[gnu::weak]] void mend(std::string& /*bytes*/, std::size_t /*most*/) {}

namespace {

/// One line, unless it is a report with a line for each mistake.
void checkMessage(const UserError& error) {
  const std::string message = error.what();
  SIMREEL_CHECK(!message.empty());
  if (error.form() == UserError::Form::sentence) SIMREEL_CHECK_EQ(message.find('\n'), std::string::npos);
}

}  // namespace

}  // namespace simreel::fuzz

extern "C" int LLVMFuzzerInitialize(int* /*count*/, char*** /*arguments*/) {
  setVerbosity(Verbosity::quiet);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    fuzz::read({reinterpret_cast<const char*>(data), size});
  } catch (const UserError& error) {
    fuzz::checkMessage(error);
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max,
                                               unsigned /*seed*/) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, max);
  std::string bytes(reinterpret_cast<const char*>(data), mutated);
  fuzz::mend(bytes, max);
  bytes.resize(std::min(bytes.size(), max));
  std::memcpy(data, bytes.data(), bytes.size());
  return bytes.size();
}
