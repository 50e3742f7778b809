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

/// Layout of the baseline folder of one scene:
///
///    state.json              state hashes of exact numerics, equal on every driver
///    steps.bin               block hashes of every step (trace.hpp)
///    any/baseline.json       pixel hash and origin of each picture, pass hashes of exact pictures
///    any/000060.png          picture of a frame; 000060.alt1.png ... are its accepted alternates
///    nvidia-hopper/...       pictures of one driver family, if it needs its own
///
/// Fast numerics differ by driver, so their state.json and steps.bin are in the profile's folder.
inline constexpr const char* sharedProfile = "any";
inline constexpr int maxAlternates = 3;

/// State hashes by "object.array", such as "flag.positions".
using StateHashes = std::map<std::string, std::string>;

struct PictureBaseline {
  struct Frame {
    std::string pixels;                   ///< pixelHash of the baseline picture
    Origin origin;                        ///< origin of the run that drew the picture
    std::vector<std::string> alternates;  ///< pixelHash of each accepted alternate
    /// Pass hashes of an exact picture by pass name (trace/passes.hpp); empty if unknown.
    std::map<std::string, std::string> passes = {};
  };
  std::string profile;
  std::string version, driver, reason;      ///< data of the latest run that wrote the baseline
  int width = 0, height = 0;                ///< size of the pictures in pixels
  std::map<std::string, double> tolerance;  ///< bounds added by hand; they override the scene's tolerance
  std::map<int, Frame> frames;
};

struct StateBaseline {
  std::map<int, StateHashes> frames;
};

/// New baseline data from a run that has not been promoted yet.
struct Candidate {
  PictureBaseline pictures;  ///< entries of this run's frames; `alternates` stays empty
  std::map<int, std::vector<std::byte>> png;
  StateBaseline state;
  std::vector<std::byte> steps;  ///< encoded step trace (steps.bin); empty if unchanged
  bool exact = true;
};

/// Returns the baseline folder of a scene: `<scene's folder>/golden/<scene>`.
[[nodiscard]] std::filesystem::path baselineFolder(const std::filesystem::path& sceneFile);
/// Returns the file name of a picture: "000060.png", or "000060.alt2.png" for an alternate.
[[nodiscard]] std::string pictureName(int frame, int alternate = 0);
/// Returns the folder of state.json and steps.bin.
[[nodiscard]] std::filesystem::path stateFolder(const std::filesystem::path& folder,
                                                const std::string& profile, bool exact);

/// Throws UserError(inputOutput) if a file of the baseline is a Git LFS pointer or has merge conflicts
/// (placeholderProblem()). In these cases the real file exists elsewhere, and overwriting would lose it.
void checkReplaceable(const std::filesystem::path& folder, const std::string& profile, bool exact);

/// Reads the picture baseline of a profile. Returns nothing if the file does not exist. Throws
/// UserError(inputOutput), whose message contains the file's name and the mistake.
[[nodiscard]] std::optional<PictureBaseline> readPictures(const std::filesystem::path& folder,
                                                          const std::string& profile);
[[nodiscard]] std::optional<StateBaseline> readState(const std::filesystem::path& stateFolder);
[[nodiscard]] std::vector<std::byte> readSteps(const std::filesystem::path& stateFolder);
/// Returns the picture baseline of the driver's profile. If it does not exist, returns the shared baseline.
[[nodiscard]] std::optional<PictureBaseline> choosePictures(const std::filesystem::path& folder,
                                                            const std::string& ownProfile);
/// Returns the profile for a new baseline drawn by a driver. Returns `ownProfile` if it has a baseline.json
/// or if the shared baseline was drawn with other numerics, and otherwise the shared profile. `numerics`:
/// fingerprint as in Origin. Do not use this function for exact pictures, which have only the shared
/// profile.
[[nodiscard]] std::string profileToWrite(const std::filesystem::path& folder, const std::string& ownProfile,
                                         const std::string& numerics);

/// Options of promote().
struct Promotion {
  std::string reason;      ///< reason for the update, stored in baseline.json; if empty, the existing
                           ///< reason is kept
  bool alternate = false;  ///< true to add the pictures as alternates instead of replacing the baseline
  bool keepOthers = true;  ///< true to keep frames that the candidate lacks
};
/// Writes the candidate's pictures and then the candidate's state into the baseline. Each file is written
/// atomically. A tolerance that was added by hand is kept. Throws UserError(inputOutput), and
/// UserError(usage) for a fourth alternate.
void promote(const std::filesystem::path& folder, const std::string& profile, const Candidate& candidate,
             const Promotion& how);

/// Updates the pass hashes of the given frames in baseline.json. Returns false if they were already equal.
/// Throws UserError(inputOutput).
bool renewPasses(const std::filesystem::path& folder, const std::string& profile,
                 const std::map<int, std::map<std::string, std::string>>& passes);

/// Parse the contents of baseline.json and state.json. Throw UserError(inputOutput), whose message contains
/// the file's name and the mistake. parsePictures() leaves PictureBaseline::profile empty, because the
/// folder's name is the profile.
[[nodiscard]] PictureBaseline parsePictures(const std::string& text, const std::string& name);
[[nodiscard]] StateBaseline parseState(const std::string& text, const std::string& name);
/// Return the texts of baseline.json and state.json, ending in a newline.
[[nodiscard]] std::string picturesText(const PictureBaseline& baseline);
[[nodiscard]] std::string stateText(const StateBaseline& baseline);

}  // namespace simreel::golden
