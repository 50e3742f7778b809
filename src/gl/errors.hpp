#pragma once

namespace simreel::gl {

/// Throws UserError(device) if the driver has rejected a call since the last check: results since then are
/// unreliable. Called wherever results leave the device.
void checkCalls();

}  // namespace simreel::gl
