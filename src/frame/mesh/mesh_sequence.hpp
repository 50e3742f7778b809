#pragma once
#include "frame/mesh/gltf_materials.hpp"
#include "sim/core/simulation.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace simreel::frame {

/// File formats that hold a surface at several frames.
/// glb: binary glTF 2.0. The mesh, materials and colours are those of the first frame. Each later frame has
/// a morph target with the differences of positions and normals from the first frame. An animation sets the
/// weights, so positions are interpolated linearly between frames.
/// pc2: PointCache2 (J. Burnett, PointCache2 readme, "PC2 File Format"), little endian. A 32-byte header
/// with the first frame's number and the step between frames precedes the positions.
/// mdd: LightWave Motion Designer (as read by Blender's MOD_meshcache_mdd.c), big endian. The counts and
/// the time of each frame, in seconds since the first frame, precede the positions.
inline constexpr std::array<const char*, 3> sequenceFormats = {"glb", "pc2", "mdd"};

/// Properties of a sequence that are known before its first frame.
struct SequencePlan {
  std::string name;         ///< name of the surface
  std::vector<int> frames;  ///< frame numbers in ascending order
  double fps = 30;
  std::vector<std::string> comments;  ///< comments for the file; ignored if the format does not support
                                      ///< comments
  sim::MeshLooks looks = {};          ///< looks of the first frame's mesh, for glb
  SkinPicturesOf skins = {};          ///< returns the textures of a material that shows a field
                                      ///< (scene::Skin); only for glb

  /// Returns the time (s) from the first frame to the frame with index `i`.
  [[nodiscard]] float seconds(std::size_t i) const {
    return static_cast<float>((frames[i] - frames[0]) / fps);
  }
};

/// Writes a surface sequence to one file. Frames are written as they are added. Only the first frame is
/// kept in memory. finish() gives the file its final name. An unfinished file is removed.
class MeshSequence {
 public:
  MeshSequence() = default;
  virtual ~MeshSequence() = default;
  MeshSequence(const MeshSequence&) = delete;
  MeshSequence& operator=(const MeshSequence&) = delete;

  /// Writes the next frame of the plan. Throws UserError(usage) if the triangles or the number of vertices
  /// differ from the first frame, or if the format cannot hold the frame. Throws UserError(inputOutput) if
  /// writing fails.
  virtual void add(const sim::MeshTable& mesh) = 0;
  /// Completes the file after the last frame. Throws UserError(inputOutput).
  virtual void finish() = 0;
};

/// Opens a sequence file of the given format. Throws UserError(usage) if the format cannot hold these
/// frames, and UserError(inputOutput) if the file cannot be created.
[[nodiscard]] std::unique_ptr<MeshSequence> openSequence(const std::string& format,
                                                         const std::filesystem::path& file,
                                                         SequencePlan plan);

}  // namespace simreel::frame
