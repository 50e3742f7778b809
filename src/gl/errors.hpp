#pragma once

namespace simreel::gl {

/// Throws UserError(device) if the driver has rejected a call since the last check, because later results
/// are unreliable. Called wherever results are read from the device.
void checkCalls();

}  // namespace simreel::gl
