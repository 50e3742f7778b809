#pragma once
#include "frame/field_file.hpp"
#include "frame/frame_sink.hpp"
#include "frame/output_name.hpp"
#include "sim/drawable.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace simreel::frame {

/// The raw values of a scene's fields beside the pictures of the same frames: 000042.png has
/// 000042.NAME.npy for each object NAME that is a field. Existing files are treated as the pictures are; on
/// --resume a file is kept where it holds what would be written.
class FieldFiles {
 public:
  /// Throws UserError(usage) where pictures have no files of their own: videos, standard output.
  FieldFiles(const OutputName& pictures, FieldFormat format, Existing existing, std::vector<int> frames);

  /// Call once, before any frame is stored. Throws UserError: usage when the scene has no field,
  /// inputOutput when files exist that must not be replaced.
  void begin(const std::vector<sim::Field>& fields);
  /// Whether anything of a frame is to be written.
  [[nodiscard]] bool wants(int frame) const;
  /// Whether it wants a frame whose files are not all there.
  [[nodiscard]] bool misses(int frame) const;

  using Contents = std::vector<std::pair<std::filesystem::path, std::vector<std::byte>>>;
  /// Reads the fields of the present frame back, encoded. Waits for the GPU.
  [[nodiscard]] Contents read(int frame, const std::vector<sim::Field>& fields) const;
  /// Throws UserError(inputOutput).
  void write(const Contents& contents) const;

 private:
  [[nodiscard]] std::filesystem::path file(int frame, const std::string& field) const;

  OutputName pictures_;
  FieldFormat format_;
  Existing existing_;
  std::vector<int> frames_;
  std::vector<std::string> names_;
};

}  // namespace simreel::frame
