#pragma once
#include "frame/file/run_info.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace simreel::frame {

/// The run and frame that a picture's file says it is of: simreel writes them into PNG and OpenEXR.
struct PictureOrigin {
  bool told = false;       ///< whether the file names a scene and a frame
  std::string difference;  ///< "seed is 7 in this run and 1 in a.png": the first item that is not the run's
  std::string state;       ///< state hash that it names; empty: none
  std::string driver;      ///< of pictures that depend on it
};

/// Compares what a picture tells with a run and one of its frames. A picture of another program tells its
/// size alone; what is no picture tells nothing.
[[nodiscard]] PictureOrigin originOf(std::span<const std::byte> file, const std::filesystem::path& name,
                                     const RunInfo& run, int frame);

}  // namespace simreel::frame
