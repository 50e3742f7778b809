#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace simreel::frame {

/// Action if an output file already exists.
enum class Existing { error, overwrite, skip, resume };

/// Parsed value of `--output`.
struct OutputName {
  enum class Kind { sequence, single, video, stream };

  Kind kind = Kind::sequence;
  std::filesystem::path folder;  ///< folder of the files; empty for the current folder
  std::string prefix;            ///< for a sequence: text before the frame number; otherwise the whole file
                                 ///< name
  std::string suffix;            ///< for a sequence: text after the frame number, including ".png" or
                                 ///< ".exr"
  int digits = 0;                ///< for a sequence: min number of digits, zero padded
  bool wholeFolder = false;      ///< for a sequence: true if the output was given as a folder rather than a
                                 ///< pattern
  /// True if manifest.json, run.json and as-run.json are written next to the frames. Without them, a run
  /// cannot be resumed.
  bool manifest = true;

  /// True if pictures are OpenEXR files with linear light before lens and film effects; false if they are
  /// display-referred bytes.
  [[nodiscard]] bool isLight() const;
  /// Returns the path of a frame in a sequence, or of the single file for other kinds.
  [[nodiscard]] std::filesystem::path file(int frame) const;
  /// Returns the file name of file(frame) without its folder.
  [[nodiscard]] std::string fileName(int frame) const;
  /// Returns the path of the manifest; empty for standard output.
  [[nodiscard]] std::filesystem::path manifestFile() const;
  /// Returns the path of run.json (run_log.hpp), next to the manifest.
  [[nodiscard]] std::filesystem::path runFile() const;
  /// Returns the path of the scene with all changes applied, next to the manifest.
  [[nodiscard]] std::filesystem::path sceneFile() const;
  /// Returns the path of the table of counts, next to the manifest; empty for standard output.
  [[nodiscard]] std::filesystem::path countFile() const;
  /// Returns the path of the checkpoint, next to the manifest. The path is empty for outputs that cannot be
  /// resumed: videos, standard output, frames without a manifest.
  [[nodiscard]] std::filesystem::path checkpointFile() const;
  /// Returns the path of a permanent checkpoint of one frame: "checkpoint.000500".
  [[nodiscard]] std::filesystem::path checkpointFile(int frame) const;
  /// Returns the folder for the pieces from which an output is assembled.
  [[nodiscard]] std::filesystem::path piecesFolder() const;

 private:
  [[nodiscard]] std::filesystem::path besideFrames(const char* ending) const;
};

/// Parses the value of `-o`: a folder (existing, with a trailing slash, or without an extension), a pattern
/// with `####` or `%04d`, `name.png` for exactly one frame, a video file, or `-` for standard output.
/// Creates no files. Throws UserError(usage), whose message lists the supported forms.
[[nodiscard]] OutputName parseOutput(const std::string& output, std::size_t frameCount);

}  // namespace simreel::frame
