#pragma once

namespace simreel::frame {

/// From here on the first SIGINT or SIGTERM is only noted, so that the frame and the manifest can be
/// finished; a second one ends the process at once with 128 + its number.
void catchInterrupts();

/// The signal that arrived, or 0. Poll it between frames; then finish() the sink and exit 128 + it.
[[nodiscard]] int interruptSignal();

/// Makes writing to a closed pipe an error (EPIPE) instead of the end of the process.
void ignoreBrokenPipes();

}  // namespace simreel::frame
