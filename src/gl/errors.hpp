#pragma once

namespace simreel::gl {

/// Throws UserError(device) where the driver has refused a call since the last check: what was computed or
/// drawn since then is not to be trusted. Called wherever results leave the device.
void checkCalls();

}  // namespace simreel::gl
