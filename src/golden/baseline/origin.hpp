#pragma once
#include <string>

namespace simreel::golden {

/// Everything besides program and scene that the bits of a picture depend on. This includes the machine,
/// because no fingerprint covers all of a driver's rasterizer. Exact pictures depend on none of it.
struct Origin {
  std::string numerics;   ///< fingerprint of floating-point arithmetic (sim::probeNumerics)
  std::string drawing;    ///< fingerprint of drawing (draw::probePictures); empty if unknown
  std::string processor;  ///< processorName; empty if unknown
  /// name and version, including Mesa's and LLVM's versions if reported; empty if unknown
  std::string driver;
  /// true for the exact rasterizer with exact numerics; all other members are then empty
  bool exact = false;
  bool operator==(const Origin&) const = default;
};
inline const Origin exactOrigin{"", "", "", "", true};

/// How closely a picture must match its baseline, in order from the strictest.
enum class Asked {
  exact,  ///< one of the two was drawn exactly: all pixels must be equal on every machine
  equal,  ///< this machine drew the baseline: all pixels must be equal
  /// another machine with the same numerics and drawing drew the baseline: within brokenNearness()
  near,
  tolerance,  ///< a machine with other numerics or drawing drew the baseline: within the scene's tolerance
};
/// Returns how closely a picture with origin `here` must match a baseline with origin `there`. An unknown
/// drawing fingerprint counts as equal, an unknown machine as different.
[[nodiscard]] Asked asked(const Origin& there, const Origin& here);
/// Returns the word for `asked` in reports: "exact", "equal", "near" or "tolerance".
[[nodiscard]] const char* askedName(Asked asked);

}  // namespace simreel::golden
