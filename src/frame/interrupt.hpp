#pragma once

namespace simreel::frame {

/// Thrown by work that a signal has ended.
struct Interrupted {
  int signal;
};

/// From here on the first SIGINT, SIGTERM, SIGHUP (unless ignored, as by nohup) or SIGXFSZ that somebody
/// sends is only noted, so that the frame and the manifest can be finished; a second one ends the process
/// at once with 128 + its number. So does the first where nothing moves any more: after 3 s without
/// processor time, its own or of children, these are ended; after 10 s the process.
void catchInterrupts();

/// The signal that arrived, or 0. Poll it between frames; then finish() the sink and exit 128 + it.
[[nodiscard]] int interruptSignal();
void throwIfInterrupted();

/// Makes writing to a closed pipe an error (EPIPE) instead of the end of the process.
void ignoreBrokenPipes();

}  // namespace simreel::frame
