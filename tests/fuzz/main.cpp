// Defines the functions that libFuzzer calls. They use the harness named by --reader=NAME.
#include "base/error.hpp"
#include "base/log.hpp"
#include "fuzz/reader.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

using namespace simreel;

// Replaces fsync(), because files of a harness need not survive a power failure, and waiting for the disk
// would take almost all of the time.
extern "C" int fsync(int /*descriptor*/) {
  return 0;
}
extern "C" int fdatasync(int /*descriptor*/) {
  return 0;
}

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max);

namespace simreel::fuzz {
namespace {

const Reader* readers = nullptr;
const Reader* asked = nullptr;
std::size_t accepted = 0;  // number of inputs that were not refused

/// Checks that a message is one line, unless it is a report, which has a line for each error.
void checkMessage(const UserError& error) {
  const std::string message = error.what();
  SIMREEL_CHECK(!message.empty());
  if (error.form() == UserError::Form::sentence) SIMREEL_CHECK_EQ(message.find('\n'), std::string::npos);
}

}  // namespace

Reader::Reader(const char* name, Read read, Mend mend) : name(name), read(read), mend(mend), next(readers) {
  readers = this;
}

}  // namespace simreel::fuzz

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  setVerbosity(Verbosity::quiet);
  constexpr std::string_view option = "--reader=";  // libFuzzer ignores options that begin with two dashes.
  for (int i = 1; i < *count; ++i)
    if (const std::string_view argument = (*arguments)[i]; argument.starts_with(option))
      for (fuzz::asked = fuzz::readers; fuzz::asked && fuzz::asked->name != argument.substr(option.size());)
        fuzz::asked = fuzz::asked->next;
  SIMREEL_CHECK(fuzz::asked != nullptr);
  std::atexit([] { std::fprintf(stderr, "stat::number_of_accepted_inputs: %zu\n", fuzz::accepted); });
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    fuzz::asked->read({reinterpret_cast<const char*>(data), size});
    ++fuzz::accepted;
  } catch (const UserError& error) {
    fuzz::checkMessage(error);
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max,
                                               unsigned /*seed*/) {
  const std::size_t mutated = LLVMFuzzerMutate(data, size, max);
  std::string bytes(reinterpret_cast<const char*>(data), mutated);
  if (fuzz::asked->mend) fuzz::asked->mend(bytes);
  bytes.resize(std::min(bytes.size(), max));
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}
