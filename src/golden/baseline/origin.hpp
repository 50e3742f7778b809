#pragma once
#include <string>

namespace simreel::golden {

/// Everything that the bits of a picture depend on, except the program and the scene. This includes the
/// machine, because no fingerprint covers all of a driver's rasterizer. Exact pictures do not depend on any
/// of it.
struct Origin {
  std::string numerics;   ///< fingerprint of floating-point arithmetic (sim::probeNumerics)
  std::string drawing;    ///< fingerprint of drawing (draw::probePictures); empty if unknown
  std::string processor;  ///< CPU name from processorName(); empty if unknown
  /// name and version of the driver, including the versions of Mesa and LLVM if reported; empty if unknown
  std::string driver;
  /// true for the exact rasterizer with exact numerics; all other members are then empty
  bool exact = false;
  bool operator==(const Origin&) const = default;
};
inline const Origin exactOrigin{"", "", "", "", true};

/// How closely a picture must match its baseline, in order from the strictest.
enum class RequiredMatch {
  exact,  ///< At least one of the two pictures was drawn exactly. All pixels must be equal on every
          ///< machine.
  equal,  ///< This machine drew the baseline. All pixels must be equal.
  /// Another machine with the same numerics and drawing drew the baseline. The picture must be within
  /// brokenNearness().
  near,
  tolerance,  ///< A machine with other numerics or drawing drew the baseline. The picture must be within
              ///< the scene's tolerance.
};
/// Returns how closely a picture with origin `here` must match a baseline with origin `there`. An unknown
/// drawing fingerprint counts as equal. An unknown machine counts as different.
[[nodiscard]] RequiredMatch requiredMatch(const Origin& there, const Origin& here);
/// Returns the word for `requiredMatch` in reports: "exact", "equal", "near" or "tolerance".
[[nodiscard]] const char* requiredMatchName(RequiredMatch requiredMatch);

}  // namespace simreel::golden
