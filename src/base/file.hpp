#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace simreel {

/// Whole file as text. `what` names the file's role in the message ("scene", "texture"). Throws UserError:
/// usage for a file that is not there, is larger than `maxBytes` or no plain file (pipes and devices may
/// never end), inputOutput for one that cannot be read.
[[nodiscard]] std::string readFile(const std::filesystem::path& path, const char* what,
                                   std::size_t maxBytes = std::size_t{1} << 30);

/// The text on standard input, read when first asked for and kept: it comes once. Throws as readFile does.
[[nodiscard]] const std::string& standardInput(const char* what, std::size_t maxBytes);

/// When a written file's name is made to last: with the file, or by the caller's syncFolder(), which does
/// so for all files of a folder at once.
enum class NameSync { now, later };

/// Writes to `path` + ".part" in the same folder (".part2" and so on where another program is at it), syncs
/// it and renames it, so that a reader sees the old file or the whole new one, after a power cut too.
/// Throws UserError(inputOutput) naming the path and the system's reason; the temporary file is removed
/// then.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes,
                         NameSync name = NameSync::now);
void writeFileAtomically(const std::filesystem::path& path, std::string_view text,
                         NameSync name = NameSync::now);

/// A file that is written piece by piece, for what does not fit into memory: as `path` + ".part", locked,
/// which takes the name once it is whole; into what is no file (a device, a pipe) it goes at once. All of
/// it throws UserError(inputOutput) naming the path and the system's reason.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path path);
  /// Removes what is not finished.
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  void append(std::span<const std::byte> bytes);
  /// Over bytes that are there already.
  void put(std::uint64_t offset, std::span<const std::byte> bytes);
  /// Syncs and renames it. Nothing may be written afterwards.
  void finish(NameSync name = NameSync::now);

 private:
  /// With errno set.
  [[noreturn]] void giveUp(const char* verb);

  std::filesystem::path path_, part_;
  int file_ = -1;
  bool open_ = true;  ///< whether there is a part to remove
};

/// For a file that another program wrote as `part`: syncs it, renames it to `path`, syncs the
/// folder. Throws UserError(inputOutput); `part` is removed then.
void renameDurably(const std::filesystem::path& part, const std::filesystem::path& path);

/// Makes the names in a folder last (empty: the current one). Where a file system cannot, nothing happens.
/// Throws UserError(inputOutput).
void syncFolder(const std::filesystem::path& folder);

/// Throws UserError(inputOutput) where writeFileAtomically() could not make this file; leaves no trace.
void checkWritable(const std::filesystem::path& path);

/// Removes a file or an empty folder, where it is there. Throws UserError(inputOutput).
void removeFile(const std::filesystem::path& path);

/// With its dot, in lower case.
[[nodiscard]] std::string lowerExtension(const std::filesystem::path& path);

/// Creates the folder and those above it. Throws UserError(inputOutput).
void makeFolders(const std::filesystem::path& folder);
/// Whether something is there; false where that cannot be found out.
[[nodiscard]] bool pathExists(const std::filesystem::path& path);

/// True if a path lies in a folder (empty: the current one) or below it, or is the folder itself, symbolic
/// links followed; neither has to be there.
[[nodiscard]] bool liesBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

/// The folder of shipped assets: $SIMREEL_ASSETS, else share/simreel/assets or assets beside the
/// program's folder, else those of the source tree that the program was built in. Empty when none exists.
[[nodiscard]] std::filesystem::path assetFolder();

/// Folder of the running program.
[[nodiscard]] std::filesystem::path programFolder();

}  // namespace simreel
