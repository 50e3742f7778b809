#pragma once

namespace simreel::golden {

/// Which baselines a run writes.
enum class Update {
  none,
  missing,  ///< those that are not there
  changed,  ///< those that differ
  all,      ///< both
  prune,    ///< none; those that nothing is tested against are removed
};

}  // namespace simreel::golden
