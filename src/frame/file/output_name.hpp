#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

namespace simreel::frame {

/// What to do where a file exists.
enum class Existing { error, overwrite, skip, resume };

/// What `--output` asks for.
struct OutputName {
  enum class Kind { sequence, single, video, stream };

  Kind kind = Kind::sequence;
  std::filesystem::path folder;  ///< of the files; empty for the current one
  std::string prefix;            ///< sequence: before the number. Otherwise the whole file name
  std::string suffix;            ///< sequence: after the number, ".png" or ".exr" included
  int digits = 0;                ///< sequence: the number is padded with zeros to so many
  bool wholeFolder = false;      ///< sequence: the folder was given, not a pattern

  /// Whether pictures are OpenEXR files, of light before lens and film; else their bytes are shown ones.
  [[nodiscard]] bool isLight() const;
  /// Where a frame of a sequence goes; the one file of any other kind.
  [[nodiscard]] std::filesystem::path file(int frame) const;
  /// Name of that file without its folder.
  [[nodiscard]] std::string fileName(int frame) const;
  /// Where the manifest goes. Empty for standard output.
  [[nodiscard]] std::filesystem::path manifestFile() const;
  /// Where what is known of the runs that made it goes (run_log.hpp), beside the manifest.
  [[nodiscard]] std::filesystem::path runFile() const;
  /// Where the scene as it was run goes, beside the manifest.
  [[nodiscard]] std::filesystem::path sceneFile() const;
  /// Where the counts of simulations go, beside the manifest. Empty for standard output.
  [[nodiscard]] std::filesystem::path countFile() const;
  /// Where checkpoints go, beside the manifest. Empty where nothing can be resumed: videos, standard
  /// output.
  [[nodiscard]] std::filesystem::path checkpointFile() const;
  /// Where the checkpoint of a frame goes that is to be kept: "checkpoint.000500".
  [[nodiscard]] std::filesystem::path checkpointFile(int frame) const;
  /// Where the pieces go of which it is made, until it is whole.
  [[nodiscard]] std::filesystem::path piecesFolder() const;

 private:
  [[nodiscard]] std::filesystem::path besideFrames(const char* ending) const;
};

/// Reads `-o`: a folder (existing, with a trailing slash, or without an extension), a pattern with
/// `####` or `%04d`, `name.png` for exactly one frame, a video file, or `-`. Creates nothing.
/// Throws UserError(usage) saying what is supported.
[[nodiscard]] OutputName parseOutput(const std::string& output, std::size_t frameCount);

}  // namespace simreel::frame
