#pragma once
#include "frame/file/run_info.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace simreel::frame {

/// Run and frame recorded in a picture file. simreel writes them into PNG and OpenEXR headers.
struct PictureOrigin {
  bool identified = false;  ///< true if the file's header names a scene and a frame
  bool otherRun = false;    ///< true if more than the number of the frame differs
  std::string difference;   ///< first difference from the run, such as "seed is 7 in this run and 1 in
                            ///< a.png"
  std::string state;        ///< recorded state hash; empty if not recorded
  std::string driver;       ///< recorded driver, for pictures that depend on the driver
};

/// Compares the header of a picture file with a run and one of the run's frames. If another program wrote
/// the picture, compares only the size. If the file is not a picture, compares nothing.
[[nodiscard]] PictureOrigin originOf(std::span<const std::byte> file, const std::filesystem::path& name,
                                     const RunInfo& run, int frame);

/// Returns the reason why a run must not replace an existing picture of one of its frames, such as "a.png
/// is no picture of simreel"; empty if it may. A run may replace what it or a killed predecessor wrote: a
/// file without content, a picture of the same run, and a damaged or other picture of simreel that its
/// manifest lists.
[[nodiscard]] std::string reasonToKeep(const std::filesystem::path& file, const RunInfo& run, int frame,
                                       bool listed);

}  // namespace simreel::frame
