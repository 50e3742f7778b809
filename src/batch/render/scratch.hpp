#pragma once
#include <filesystem>
#include <set>
#include <string>

namespace simreel::batch {

/// Replaces $NAME in a path with this machine's environment variables: '/local/$SLURM_JOB_ID'. Throws
/// UserError(usage) if a variable is not set.
[[nodiscard]] std::filesystem::path scratchRoot(const std::string& text);

/// Folder on a node's local disk that is used instead of a shared folder during one run. The constructor
/// copies files of an earlier attempt from the shared folder. deliver() copies the results back. It must be
/// called even after an error or an interrupt, so that any other node can continue. If a node dies, its
/// local files are lost.
class Scratch {
 public:
  /// `root`: local folder in which a new folder is created. If it is empty, folder() is the shared folder.
  /// Throws UserError(inputOutput).
  Scratch(std::filesystem::path shared, const std::filesystem::path& root);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  Scratch(Scratch&&) = delete;
  Scratch& operator=(Scratch&&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const { return own_.empty() ? shared_ : own_; }
  /// Copies all changed files back to the shared folder. Manifests come last, so that the files that they
  /// list exist. Removes files of the shared folder that the run has removed from its local copy. Copies
  /// instead of renaming, because a rename cannot move files to another file system. Throws
  /// UserError(inputOutput).
  void deliver();

 private:
  void removeLeftovers(const std::filesystem::path& root, const std::string& name) const;
  void bring();

  std::filesystem::path shared_, own_;
  std::set<std::string> brought_;
};

}  // namespace simreel::batch
