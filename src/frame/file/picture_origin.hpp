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
  std::string difference;   ///< first difference from the run, such as "seed is 7 in this run and 1 in
                            ///< a.png"
  std::string state;        ///< recorded state hash; empty if not recorded
  std::string driver;       ///< recorded driver, for pictures that depend on the driver
};

/// Compares the header of a picture file with a run and one of the run's frames. If another program wrote
/// the picture, compares only the size. If the file is not a picture, compares nothing.
[[nodiscard]] PictureOrigin originOf(std::span<const std::byte> file, const std::filesystem::path& name,
                                     const RunInfo& run, int frame);

}  // namespace simreel::frame
