#pragma once
#include <string>

namespace simreel::golden {

/// What the bits of a picture depend on beside the program and the scene. No fingerprint can know all of a
/// driver's rasterizer, hence the machine.
struct Origin {
  std::string numerics;   ///< fingerprint of arithmetic (sim::probeNumerics)
  std::string drawing;    ///< fingerprint of drawing (draw::probePictures); empty: not known
  std::string processor;  ///< processorName; empty: not known
  std::string driver;     ///< name and version, those of Mesa and LLVM where it says them; empty: not known
  bool operator==(const Origin&) const = default;
};

/// How close a picture has to be to its baseline.
enum class Asked {
  equal,      ///< this machine drew the baseline
  near,       ///< another one of the same numerics did: brokenNearness()
  tolerance,  ///< one of other numerics did: the scene's tolerance
};
/// What `here` is asked for by a baseline of `there`. A fingerprint that is not known is taken for the
/// other's, a machine that is not known for another one.
[[nodiscard]] Asked asked(const Origin& there, const Origin& here);
/// As reports spell it: "equal", "near", "tolerance".
[[nodiscard]] const char* askedName(Asked asked);

}  // namespace simreel::golden
