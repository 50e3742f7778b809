#pragma once

namespace simreel::golden {

/// Selects which baselines a run writes.
enum class Update {
  none,
  missing,  ///< baselines that do not exist
  changed,  ///< baselines that differ
  all,      ///< missing and changed baselines
  prune,    ///< writes none; removes baselines that no test uses
};

}  // namespace simreel::golden
