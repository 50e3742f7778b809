#pragma once
#include "base/strict_json.hpp"
#include "frame/file/run_info.hpp"
#include "frame/file/world_state.hpp"
#include "sim/world/world.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::frame {

/// Saved state of a simulation between two frames. The file consists of a JSON header line (simulation,
/// frame, and names and sizes of the parts), the table of counts, the parts, and a hash of everything
/// before it (src/batch/README.md). Only the program version that wrote a checkpoint can read it. A
/// checkpoint fits any run of the same simulation, regardless of which frames the run draws.
class Checkpoint {
 public:
  /// Reads back the world's state and writes it atomically. `counts`: the table of counts up to the current
  /// frame. Throws UserError(inputOutput).
  static void write(const std::filesystem::path& file, const RunInfo& run, const std::string& stateHash,
                    const std::string& counts, sim::World& world);
  /// Loads a checkpoint. Throws UserError(usage) if the file is not a complete checkpoint of this program
  /// version, and UserError(inputOutput) if it cannot be read.
  [[nodiscard]] static Checkpoint load(const std::filesystem::path& file);
  /// Returns the reason why `run` cannot continue from the checkpoint, or nothing if it can. One reason is
  /// that the simulation differs. The other is that the numerics are fast and the numerics fingerprint of
  /// the driver differs.
  [[nodiscard]] std::optional<std::string> mismatch(const RunInfo& run) const;
  /// Reads a checkpoint. Returns nothing if the file does not exist. If `run` cannot continue from the
  /// file, warns and returns nothing. `lastFrame`: last frame of the run; a checkpoint of a later frame is
  /// rejected.
  [[nodiscard]] static std::optional<Checkpoint> read(const std::filesystem::path& file, const RunInfo& run,
                                                      int lastFrame);

  /// Restores the state into a world of the same scene. The world's current frame becomes frame(). If a
  /// part does not fit, throws UserError(usage), and the world is then unusable.
  void restore(sim::World& world) const;
  /// Returns a copy of the state.
  [[nodiscard]] WorldState state() const;

  [[nodiscard]] int frame() const { return frame_; }
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] const std::string& stateHash() const { return stateHash_; }
  [[nodiscard]] std::string_view counts() const;

 private:
  void readHeader();
  void readParts(const JsonValue& header);

  std::filesystem::path file_;
  int frame_ = 0;
  std::string simulation_, numerics_, fingerprint_;
  std::string stateHash_;
  std::size_t countBytes_ = 0;
  std::vector<StatePart> parts_;
  std::string text_;         ///< content of the checkpoint file
  std::size_t payload_ = 0;  ///< offset of the table of counts in text_; the parts follow the table
};

}  // namespace simreel::frame
