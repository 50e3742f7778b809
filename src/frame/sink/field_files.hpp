#pragma once
#include "frame/file/field_file.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"
#include "sim/core/drawable.hpp"

#include <string>
#include <vector>

namespace simreel::frame {

/// The raw values of a scene's fields beside the pictures of the same frames: 000042.png has
/// 000042.NAME.npy for each object NAME that is a field. Existing files are treated as the pictures are; on
/// --resume those are kept that the manifest and their hashes say are whole.
class FieldFiles {
 public:
  /// Throws UserError(usage) where pictures have no files of their own: videos, standard output.
  FieldFiles(const OutputName& pictures, FieldFormat format, Existing existing, std::vector<int> frames);

  /// Call once, before any frame is stored. Throws UserError: usage when the scene has no field,
  /// inputOutput when files exist that must not be replaced.
  void begin(const std::vector<sim::Field>& fields);
  /// Whether anything of a frame is to be written; `sink` knows what is whole.
  [[nodiscard]] bool misses(int frame, const FrameSink& sink) const;
  /// Reads the fields of the present frame back whose files are to be written, encoded. Waits for the GPU.
  [[nodiscard]] std::vector<FrameFile> read(int frame, const std::vector<sim::Field>& fields,
                                            const FrameSink& sink) const;

 private:
  [[nodiscard]] std::string fileName(int frame, const std::string& field) const;
  [[nodiscard]] bool misses(int frame, const std::string& field, const FrameSink& sink) const;

  OutputName pictures_;
  FieldFormat format_;
  Existing existing_;
  std::vector<int> frames_;
  std::vector<std::string> names_;
};

}  // namespace simreel::frame
