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

/// The state between two frames of a simulation, on disk: a line of JSON that says of which simulation and
/// frame it is and which parts follow, their bytes, and a hash of all that (src/batch/README.md). Only the
/// program version that wrote it reads it, for any run of the same simulation, whatever that draws of it.
class Checkpoint {
 public:
  /// Reads the world's state back and writes it atomically. `counts`: the table of counts so far. Throws
  /// UserError(inputOutput).
  static void write(const std::filesystem::path& file, const RunInfo& run, const std::string& stateHash,
                    const std::string& counts, sim::World& world);
  /// Throws UserError(usage) where the file is no whole checkpoint of this program, inputOutput where it
  /// cannot be read.
  [[nodiscard]] static Checkpoint load(const std::filesystem::path& file);
  /// Why this run cannot go on from it: it is of another simulation, or of numerics that differ from one
  /// driver to the next and another driver.
  [[nodiscard]] std::optional<std::string> mismatch(const RunInfo& run) const;
  /// Nothing when the file does not exist, or is none that this run can go on from: says so in a warning
  /// then. `lastFrame` of the run: none lies beyond it.
  [[nodiscard]] static std::optional<Checkpoint> read(const std::filesystem::path& file, const RunInfo& run,
                                                      int lastFrame);

  /// Puts the state into the world of the same scene, whose present frame is frame() then. Throws
  /// UserError(usage) where a part does not fit; the world is of no use then.
  void restore(sim::World& world) const;

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
  std::string text_;         ///< the file
  std::size_t payload_ = 0;  ///< where the table of counts begins in it; the parts follow
};

}  // namespace simreel::frame
