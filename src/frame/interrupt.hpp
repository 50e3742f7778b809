#pragma once

namespace simreel::frame {

/// Exception thrown by work that a signal interrupted.
struct Interrupted {
  int signal;
};

/// Installs signal handlers. The first SIGINT, SIGTERM, SIGHUP (unless ignored, as by nohup) or SIGXFSZ
/// sent by a process only sets a flag, so that the current frame and the manifest can be finished. A second
/// signal exits at once with the code 128 + signal number. After the first signal, a watchdog detects
/// hangs. If the process and its children use no CPU time for 3 s, the watchdog ends the children. After 10
/// s without CPU time, it ends the process.
void catchInterrupts();

/// Returns the signal that arrived, or 0. Call it between frames. If the result is not 0, call finish() on
/// the sink and exit with 128 + the signal.
[[nodiscard]] int interruptSignal();
void throwIfInterrupted();
/// Makes throwIfInterrupted() throw as if `signal` had arrived. 0 cancels this, but not a signal that did
/// arrive. Safe in any thread.
void setInterrupt(int signal);
/// Makes long frames end with the exception Interrupted after a signal. They end where they call
/// checkFrame(). catchInterrupts() must have been called.
void interruptFrames();

/// Ignores SIGPIPE, so that writing to a closed pipe fails with EPIPE instead of ending the process.
void ignoreBrokenPipes();

}  // namespace simreel::frame
