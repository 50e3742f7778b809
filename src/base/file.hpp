#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace simreel {

/// Returns the contents of a file. `what`: role of the file in messages ("scene", "texture"). Throws
/// UserError(usage) if the file does not exist, is larger than `maxBytes` or is not a regular file (pipes
/// and devices may never end). Throws UserError(inputOutput) if it cannot be read.
[[nodiscard]] std::string readFile(const std::filesystem::path& path, const char* what,
                                   std::size_t maxBytes = std::size_t{1} << 30);

/// Returns the text on standard input. The first call reads and stores it, because standard input can be
/// read only once. Throws the same errors as readFile().
[[nodiscard]] const std::string& standardInput(const char* what, std::size_t maxBytes);

/// Time at which the folder entry of a written file is synced to disk. now: together with the file. later:
/// by a call of syncFolder(), which syncs the entries of all files of a folder.
enum class NameSync { now, later };

/// Writes a file so that readers see either the old file or the complete new one, even after a power
/// failure. Writes to `path` + ".part" in the same folder (".part2" and so on if another program has locked
/// that file), syncs it and renames it. On failure, removes the temporary file and throws
/// UserError(inputOutput) with the path and the system's reason.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes,
                         NameSync name = NameSync::now);
void writeFileAtomically(const std::filesystem::path& path, std::string_view text,
                         NameSync name = NameSync::now);

/// File that is written in parts, for data that do not fit into memory. Writes to a locked file `path` +
/// ".part" and renames it when it is complete. Writes directly to devices and pipes. All functions throw
/// UserError(inputOutput) with the path and the system's reason.
class PartFile {
 public:
  explicit PartFile(std::filesystem::path path);
  /// Removes the temporary file if finish() has not been called.
  ~PartFile();
  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;

  void append(std::span<const std::byte> bytes);
  /// Overwrites bytes that were written before, starting at `offset`.
  void put(std::uint64_t offset, std::span<const std::byte> bytes);
  /// Syncs and renames the file. Nothing may be written after this call.
  void finish(NameSync name = NameSync::now);

 private:
  /// Removes the temporary file and throws. errno must contain the reason.
  [[noreturn]] void giveUp(const char* verb);

  std::filesystem::path path_, part_;
  int file_ = -1;
  bool open_ = true;  ///< true while there is a temporary file to remove
};

/// Syncs the file `part`, which another program wrote, renames it to `path` and syncs the folder. On
/// failure, removes `part` and throws UserError(inputOutput).
void renameDurably(const std::filesystem::path& part, const std::filesystem::path& path);

/// Syncs the entries of a folder, so that new names survive a power failure. An empty path means the
/// current folder. Does nothing if the file system cannot sync folders. Throws UserError(inputOutput).
void syncFolder(const std::filesystem::path& folder);

/// Throws UserError(inputOutput) if writeFileAtomically() could not write this file. Does not leave a file.
void checkWritable(const std::filesystem::path& path);

/// Removes a file or an empty folder if it exists. Throws UserError(inputOutput).
void removeFile(const std::filesystem::path& path);

/// Returns the extension in lower case, including the dot.
[[nodiscard]] std::string lowerExtension(const std::filesystem::path& path);

/// Creates the folder and its parents. Throws UserError(inputOutput).
void makeFolders(const std::filesystem::path& folder);
/// True if a file or folder exists at the path. False if the system reports an error.
[[nodiscard]] bool pathExists(const std::filesystem::path& path);

/// True if `path`, with symbolic links resolved, is `folder` or lies below it. An empty `folder` means the
/// current folder. Neither path has to exist.
[[nodiscard]] bool liesBelow(const std::filesystem::path& path, const std::filesystem::path& folder);

/// Returns the first existing folder of shipped assets. Tries $SIMREEL_ASSETS, then share/simreel/assets
/// and assets next to the program's folder, then the assets of the source tree of this build. Returns an
/// empty path if no such folder exists.
[[nodiscard]] std::filesystem::path assetFolder();

/// Returns the file that contains this code. It is the running program, or a shared library that the
/// program has loaded.
[[nodiscard]] std::filesystem::path programFile();
/// Returns the folder of programFile().
[[nodiscard]] std::filesystem::path programFolder();

}  // namespace simreel
