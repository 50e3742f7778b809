#include "cli/help/exit_codes.hpp"

#include <array>

namespace simreel::cli {

std::span<const ExitMeaning> exitMeanings() {
  static constexpr std::array<ExitMeaning, 9> all = {{
      {"0", "success", "Nothing to do."},
      {"1", "pictures, states or checks differ, or a job of a sweep failed",
       "Open the report (`simreel test --report FOLDER`), or compare two files with `simreel diff A B`. If "
       "the change is wanted, accept it: `simreel accept` or `simreel test --update`. `simreel sweep "
       "status "
       "FOLDER` says why a job failed."},
      {"2", "mistake in the command line or the scene",
       "Read the message: it names the option, or the line and column of the scene. `simreel validate "
       "SCENE` lists every mistake at once."},
      {"3", "a baseline, a job of a sweep or a piece is missing",
       "Make a baseline with `simreel test --update=missing`, look at the pictures, and commit them. Run "
       "missing jobs with `simreel sweep retry FOLDER`, and missing pieces with `--resume`."},
      {"4", "no usable device, a device limit, memory, or a state lost to NaN",
       "Run `simreel doctor`: it lists the devices and what is wrong with them. If the state was lost, the "
       "message names the object and the frame: take smaller steps (`substeps`) or smaller values."},
      {"5", "nothing ran",
       "The filter, shard or folder matched no scene or picture. `simreel test --list` prints what would "
       "run."},
      {"6", "a file cannot be read or written, or is damaged",
       "Check the path, the permissions and the free space. Make a damaged file again."},
      {"7", "jobs of a sweep or pieces are queued, running or aborted",
       "Wait, then ask again: `simreel sweep status FOLDER` or `simreel pieces status FOLDER`. Run aborted "
       "jobs again: `simreel sweep retry FOLDER`."},
      {"128 + n", "ended by signal n (130: Ctrl+C)",
       "Run the same command again with `--resume`: frames that are whole are kept."},
  }};
  return all;
}

}  // namespace simreel::cli
