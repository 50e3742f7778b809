#pragma once
#include <string>

namespace simreel::golden {

/// What the bits of a picture depend on beside the program and the scene. No fingerprint can know all of a
/// driver's rasterizer, hence the machine. Exact pictures depend on none of it.
struct Origin {
  std::string numerics;   ///< fingerprint of arithmetic (sim::probeNumerics)
  std::string drawing;    ///< fingerprint of drawing (draw::probePictures); empty: not known
  std::string processor;  ///< processorName; empty: not known
  std::string driver;     ///< name and version, those of Mesa and LLVM where it says them; empty: not known
  bool exact = false;     ///< by the exact rasterizer, of exact numerics; then all else is empty
  bool operator==(const Origin&) const = default;
};
inline const Origin exactOrigin{"", "", "", "", true};

/// How close a picture has to be to its baseline; the strictest first.
enum class Asked {
  exact,      ///< one of the two was drawn exactly: no pixel may differ on any machine
  equal,      ///< this machine drew the baseline
  near,       ///< another one of the same numerics did: brokenNearness()
  tolerance,  ///< one of other numerics did: the scene's tolerance
};
/// What `here` is asked for by a baseline of `there`. A fingerprint that is not known is taken for the
/// other's, a machine that is not known for another one.
[[nodiscard]] Asked asked(const Origin& there, const Origin& here);
/// As reports spell it: "exact", "equal", "near", "tolerance".
[[nodiscard]] const char* askedName(Asked asked);

}  // namespace simreel::golden
