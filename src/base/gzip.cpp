#include "base/gzip.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include <isa-l/igzip_lib.h>

namespace simreel {

bool isGzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

std::string unpackedGzip(std::string_view bytes, const std::string& name, std::size_t maxBytes) {
  constexpr std::size_t piece = std::size_t{1} << 20;
  const auto state = std::make_unique<inflate_state>();
  std::vector<std::uint8_t> buffer(piece);
  std::string all;
  while (!bytes.empty()) {
    isal_inflate_init(state.get());
    state->crc_flag = ISAL_GZIP;
    // The library only reads the input, but its interface lacks const.
    state->next_in = reinterpret_cast<std::uint8_t*>(const_cast<char*>(bytes.data()));  // NOLINT
    state->avail_in = static_cast<std::uint32_t>(std::min(bytes.size(), std::size_t{1} << 31));
    while (state->block_state != ISAL_BLOCK_FINISH) {
      state->next_out = buffer.data();
      state->avail_out = piece;
      const std::uint32_t before = state->avail_in;
      if (isal_inflate(state.get()) != ISAL_DECOMP_OK)
        fail(ExitCode::inputOutput, "{} is damaged: its gzip data cannot be unpacked", name);
      const std::size_t made = piece - state->avail_out;
      if (made == 0 && before == state->avail_in && state->block_state != ISAL_BLOCK_FINISH)
        fail(ExitCode::inputOutput, "{} is cut off within its gzip data", name);
      if (all.size() + made > maxBytes)
        fail(ExitCode::usage, "{} unpacks to more than {} MiB", name, maxBytes >> 20U);
      all.append(reinterpret_cast<const char*>(buffer.data()), made);
    }
    bytes.remove_prefix(bytes.size() - state->avail_in);
    if (!isGzip(bytes))
      break;  // The remaining bytes need not be a further member. They may be, for example, zeros that pad
              // the file to a multiple of the block size.
  }
  return all;
}

}  // namespace simreel
