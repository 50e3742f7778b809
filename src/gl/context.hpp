#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace simreel::gl {

/// The way in which shaders read performance-critical inputs. Software drivers load texels 10 to 30 times
/// faster than storage blocks; GPUs are faster with storage blocks and shared memory (DESIGN.md).
enum class MemoryPath { storage, texel };

/// One EGL device of the system.
struct DeviceInfo {
  int index = 0;
  std::string name;  ///< GL_RENDERER if a context could be created, else a name from EGL
  std::string vendor;
  std::string version;  ///< GL_VERSION
  bool software = false;
  std::string problem;  ///< reason why the device cannot run the program; empty if it can
};

/// Returns all EGL devices and tests each by creating a context on it. Empty if EGL finds no device.
[[nodiscard]] std::vector<DeviceInfo> listDevices();

struct ContextOptions {
  std::string device;  ///< index, or part of a name (case-insensitive); empty: a hardware device if
                       ///< possible, else a software driver
  bool debug = false;  ///< creates a debug context; high-severity messages become UserError(device) at the
                       ///< next check
  std::string memoryPath;  ///< "storage", "texel" or empty (chosen by driver)

  /// Returns the options for worker process number `place` (zero-based) of several parallel processes. The
  /// workers take the devices of a list such as "0,1" in turn. A comma before a space belongs to a device
  /// name.
  [[nodiscard]] ContextOptions ofWorker(std::size_t place) const;
  /// Number of devices that `device` lists, at least 1.
  [[nodiscard]] std::size_t deviceCount() const;
};

/// Owns an OpenGL 4.5 core context without a surface, current on the thread that created it. Throws
/// UserError(device) that says what was required, what was found and what to install.
class Context {
 public:
  explicit Context(const ContextOptions& options = {});
  ~Context();
  Context(Context&&) = delete;
  Context(const Context&) = delete;
  Context& operator=(Context&&) = delete;
  Context& operator=(const Context&) = delete;

  [[nodiscard]] const DeviceInfo& device() const;
  [[nodiscard]] const std::string& reason() const;  ///< reason for the choice of this device, one clause
  /// Throws UserError(device) with the first high-severity debug message since the last call, if any.
  void check() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Owns a further context on the device of the current Context, current on the thread that creates it. It
/// shares no objects with the Context and must be destroyed before it.
class SideContext {
 public:
  /// Returns null if the driver cannot create a further context, or if there is no Context.
  static std::unique_ptr<SideContext> make();
  ~SideContext();
  SideContext(SideContext&&) = delete;
  SideContext(const SideContext&) = delete;
  SideContext& operator=(SideContext&&) = delete;
  SideContext& operator=(const SideContext&) = delete;

 private:
  SideContext(void* display, void* context) : display_(display), context_(context) {}
  void* display_;  ///< EGLDisplay
  void* context_;  ///< EGLContext
};

/// Memory path of the current context.
[[nodiscard]] MemoryPath memoryPath();
/// True if the current context renders on the CPU. Some filters then cost too much for their visible
/// effect.
[[nodiscard]] bool softwareDriver();

}  // namespace simreel::gl
