#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::gl {

/// How shaders read performance-critical inputs. Software drivers load texels 10 to 30 times faster than
/// storage blocks. GPUs are faster with storage blocks and shared memory (DESIGN.md).
enum class MemoryPath { storage, texel };

/// One EGL device of the system.
struct DeviceInfo {
  int index = 0;
  std::string name;  ///< GL_RENDERER if a context could be created, otherwise a name from EGL
  std::string vendor;
  std::string version;  ///< GL_VERSION
  bool software = false;
  std::string problem;  ///< reason why the device cannot run the program; empty if it can
};

/// Returns all EGL devices, after testing each by creating a context on it. Returns none if EGL finds no
/// device.
[[nodiscard]] std::vector<DeviceInfo> listDevices();

struct ContextOptions {
  std::string device;  ///< index of the device, or part of its name (case-insensitive); if empty, a
                       ///< hardware device is chosen if possible, and otherwise a software driver
  bool debug = false;  ///< creates a debug context; high-severity messages become UserError(device) at the
                       ///< next check
  std::string memoryPath;  ///< "storage" or "texel"; if empty, the driver determines the path

  /// Returns the options for the worker process with index `place` among several parallel processes. If
  /// `device` is a list such as "0,1", successive workers get successive devices. A comma before a space is
  /// part of a device name.
  [[nodiscard]] ContextOptions ofWorker(std::size_t place) const;
  /// Returns the number of devices that `device` lists, at least 1.
  [[nodiscard]] std::size_t deviceCount() const;
  /// Returns the memory path on a driver with the name `device`. Throws UserError: usage for another word,
  /// device for "texel" on hardware.
  [[nodiscard]] MemoryPath memoryPathOn(bool software, std::string_view device) const;
};

/// Owns an OpenGL 4.5 core context without a surface, which is current on the thread that created it. If no
/// suitable context can be created, the constructor throws UserError(device) whose message says what was
/// required, what was found and what to install.
class Context {
 public:
  explicit Context(const ContextOptions& options = {});
  ~Context();
  Context(Context&&) = delete;
  Context(const Context&) = delete;
  Context& operator=(Context&&) = delete;
  Context& operator=(const Context&) = delete;

  [[nodiscard]] const DeviceInfo& device() const;
  [[nodiscard]] const std::string& reason() const;  ///< Returns the reason for the choice of this device as
                                                    ///< one clause.
  /// Throws UserError(device) with the first high-severity debug message since the last call. Does nothing
  /// if there is no such message.
  void check() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Owns an additional context on the device of the current Context, which is current on the thread that
/// created it. It shares no objects with the Context and must be destroyed before it.
class SideContext {
 public:
  /// Creates the context. Returns null if the driver cannot create another context, or if there is no
  /// Context.
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

/// Returns the memory path of the current context.
[[nodiscard]] MemoryPath memoryPath();
/// True if the current context renders on the CPU. Some filters then cost too much for their visible
/// effect.
[[nodiscard]] bool softwareDriver();

}  // namespace simreel::gl
