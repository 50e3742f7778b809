#pragma once
#include "frame/file/field_file.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"
#include "sim/core/drawable.hpp"

#include <string>
#include <vector>

namespace simreel::frame {

/// Writes the raw values of a scene's fields next to the pictures. The frame 000042.png gets
/// 000042.NAME.npy for each field NAME, or for each chosen field. Existing field files are treated like
/// existing pictures. --resume keeps the files that are complete according to the hashes in the manifest.
class FieldFiles {
 public:
  /// Throws UserError(usage) if the output has no picture files (video, standard output).
  FieldFiles(const OutputName& pictures, FieldChoice choice, Existing existing, std::vector<int> frames);

  /// Checks the fields and the existing files. Call once, before the first frame is stored. Throws
  /// UserError(usage) if the scene has no field or lacks a chosen one, and UserError(inputOutput) if files
  /// exist that must not be replaced.
  void begin(const std::vector<sim::Field>& fields);
  /// True if a field file of the frame must be written. `sink` knows which files are already complete.
  [[nodiscard]] bool misses(int frame, const FrameSink& sink) const;
  /// Reads back and encodes the fields of the current frame whose files must be written. Waits for the GPU.
  [[nodiscard]] std::vector<FrameFile> read(int frame, const std::vector<sim::Field>& fields,
                                            const FrameSink& sink) const;

 private:
  [[nodiscard]] bool isChosen(const sim::Field& field) const;
  [[nodiscard]] std::string fileName(int frame, const std::string& field) const;
  [[nodiscard]] bool misses(int frame, const std::string& field, const FrameSink& sink) const;

  OutputName pictures_;
  FieldChoice choice_;
  Existing existing_;
  std::vector<int> frames_;
  std::vector<std::string> names_;
};

}  // namespace simreel::frame
