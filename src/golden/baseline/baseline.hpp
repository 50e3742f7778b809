#pragma once
#include "frame/image.hpp"
#include "golden/baseline/origin.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace simreel::golden {

/// Baselines of one scene live in one folder:
///
///     state.json              state hashes of exact numerics, the same on every driver
///     steps.bin               block hashes of every step (trace.hpp)
///     any/baseline.json       pixel hash and origin of each picture, hashes of an exact one's passes
///     any/000060.png          a frame; 000060.alt1.png ... its accepted alternates
///     nvidia-hopper/...       pictures of one numerics family, where its own are wanted
///
/// Fast numerics differ by driver, so state.json and steps.bin stand in the profile's folder then.
inline constexpr const char* sharedProfile = "any";
inline constexpr int maxAlternates = 3;

/// "flag.positions" -> hash.
using StateHashes = std::map<std::string, std::string>;

struct PictureBaseline {
  struct Frame {
    std::string pixels;                   ///< pixelHash
    Origin origin;                        ///< of the run that drew it
    std::vector<std::string> alternates;  ///< pixelHash of each
    /// Hash of each pass of an exact picture, by its name (trace/passes.hpp); empty: not known.
    std::map<std::string, std::string> passes = {};
  };
  std::string profile;
  std::string version, driver, reason;      ///< of the run that wrote it last
  int width = 0, height = 0;                ///< pixels
  std::map<std::string, double> tolerance;  ///< written by a person; wins over the scene's
  std::map<int, Frame> frames;
};

struct StateBaseline {
  std::map<int, StateHashes> frames;
};

/// What a run would have the baseline be.
struct Candidate {
  PictureBaseline pictures;  ///< the frames of this run; alternates empty
  std::map<int, std::vector<std::byte>> png;
  StateBaseline state;
  std::vector<std::byte> steps;  ///< encoded trace; empty: unchanged
  bool exact = true;
};

/// `<scene's folder>/golden/<scene>`.
[[nodiscard]] std::filesystem::path baselineFolder(const std::filesystem::path& sceneFile);
/// "000060.png", or "000060.alt2.png".
[[nodiscard]] std::string pictureName(int frame, int alternate = 0);
/// Where state.json and steps.bin stand.
[[nodiscard]] std::filesystem::path stateFolder(const std::filesystem::path& folder,
                                                const std::string& profile, bool exact);

/// Throws UserError(inputOutput) where a file of the baseline holds the place of another
/// (standsForAnother()): that one exists, and would be lost if this were written anew.
void checkReplaceable(const std::filesystem::path& folder, const std::string& profile, bool exact);

/// Nothing where there is no such file. Throws UserError(inputOutput) naming the file and the mistake.
[[nodiscard]] std::optional<PictureBaseline> readPictures(const std::filesystem::path& folder,
                                                          const std::string& profile);
[[nodiscard]] std::optional<StateBaseline> readState(const std::filesystem::path& stateFolder);
[[nodiscard]] std::vector<std::byte> readSteps(const std::filesystem::path& stateFolder);
/// The baseline of this family, else the shared one.
[[nodiscard]] std::optional<PictureBaseline> choosePictures(const std::filesystem::path& folder,
                                                            const std::string& ownProfile);
/// Where a new baseline of a driver's pictures goes: `own` where that exists, else the shared one unless it
/// was drawn with other numerics (a fingerprint as in Origin). Exact pictures have the shared one alone.
[[nodiscard]] std::string profileToWrite(const std::filesystem::path& folder, const std::string& ownProfile,
                                         const std::string& numerics);

/// How promote() treats what it finds.
struct Promotion {
  std::string reason;      ///< kept in baseline.json; empty: the one there stays
  bool alternate = false;  ///< add as an alternate instead of replacing
  bool keepOthers = true;  ///< keep frames that the candidate does not have
};
/// Writes the candidate's frames and state into the baseline, pictures first, every file whole or not at
/// all. The tolerance a person wrote stays. Throws UserError(inputOutput), and usage for a fourth
/// alternate.
void promote(const std::filesystem::path& folder, const std::string& profile, const Candidate& candidate,
             const Promotion& how);

/// Writes the hashes of passes into what is listed of these frames' pictures; false where they stand there
/// already. Throws UserError(inputOutput).
bool renewPasses(const std::filesystem::path& folder, const std::string& profile,
                 const std::map<int, std::map<std::string, std::string>>& passes);

/// The contents of baseline.json and state.json. Throw UserError(inputOutput) naming the file and the
/// mistake. The profile is the folder's name, which the text does not hold.
[[nodiscard]] PictureBaseline parsePictures(const std::string& text, const std::string& name);
[[nodiscard]] StateBaseline parseState(const std::string& text, const std::string& name);
/// The texts of baseline.json and state.json, ending in a newline.
[[nodiscard]] std::string picturesText(const PictureBaseline& baseline);
[[nodiscard]] std::string stateText(const StateBaseline& baseline);

}  // namespace simreel::golden
