#pragma once
#include <filesystem>
#include <set>
#include <string>

namespace simreel::batch {

/// "$NAME" in a path by the environment of the machine that asks: '/local/$SLURM_JOB_ID'. Throws
/// UserError(usage) for what is not set there.
[[nodiscard]] std::filesystem::path scratchRoot(const std::string& text);

/// A folder of a node's own disk in place of a shared one, for as long as one run takes. What an earlier
/// attempt has left in the shared folder is brought; what is there at the end goes back: also after an
/// error or an interrupt, so that any other node goes on from there. A node that dies takes its own part
/// along.
class Scratch {
 public:
  /// `root`: where; empty: there is none, and folder() is the shared one. Throws UserError(inputOutput).
  Scratch(std::filesystem::path shared, const std::filesystem::path& root);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  Scratch(Scratch&&) = delete;
  Scratch& operator=(Scratch&&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const { return own_.empty() ? shared_ : own_; }
  /// Copies back all that differs, each file as a whole and manifests last: what they list is there; of
  /// what was brought removes what the run has removed. Nothing is renamed from one file system to the
  /// other. Throws UserError(inputOutput).
  void deliver();

 private:
  void removeLeftovers(const std::filesystem::path& root, const std::string& name) const;
  void bring();

  std::filesystem::path shared_, own_;
  std::set<std::string> brought_;
};

}  // namespace simreel::batch
