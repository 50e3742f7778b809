#pragma once
#include "sim/core/simulation.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace simreel::frame {

/// Formats of a file that holds a surface at several frames.
/// glb: binary glTF 2.0 whose mesh is the first frame and whose morph targets, with normals, are what the
/// others add to it; an animation sets the weights, so that between two frames positions go straight.
/// pc2: PointCache2 (J. Burnett, PointCache2 readme, "PC2 File Format"): little endian, 32 bytes of header
/// with the first frame's number and the frames between two, then positions.
/// mdd: LightWave's Motion Designer (as Blender's MOD_meshcache_mdd.c reads it): big endian, counts, the
/// seconds of each frame since the first, then positions.
inline constexpr std::array<const char*, 3> sequenceFormats = {"glb", "pc2", "mdd"};

/// What is known of a sequence before its first frame.
struct SequencePlan {
  std::string name;         ///< of the surface
  std::vector<int> frames;  ///< ascending
  double fps = 30;
  std::vector<std::string> comments;  ///< for formats that have room for them

  /// s from the first frame to a later one.
  [[nodiscard]] float seconds(std::size_t i) const {
    return static_cast<float>((frames[i] - frames[0]) / fps);
  }
};

/// A surface frame by frame as one file. A frame is written when it is added, and no other is kept than the
/// first. The file takes its name when it is finished; one that is not is removed.
class MeshSequence {
 public:
  MeshSequence() = default;
  virtual ~MeshSequence() = default;
  MeshSequence(const MeshSequence&) = delete;
  MeshSequence& operator=(const MeshSequence&) = delete;

  /// The next frame of the plan. Throws UserError: usage for one that has other triangles, or more
  /// vertices, than the first, or that there is no room for in the format; inputOutput.
  virtual void add(const sim::MeshTable& mesh) = 0;
  /// After the last. Throws UserError(inputOutput).
  virtual void finish() = 0;
};

/// Throws UserError(usage) where the format cannot hold these frames, and UserError(inputOutput).
[[nodiscard]] std::unique_ptr<MeshSequence> openSequence(const std::string& format,
                                                         const std::filesystem::path& file,
                                                         SequencePlan plan);

}  // namespace simreel::frame
