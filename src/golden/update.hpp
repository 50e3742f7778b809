#pragma once

namespace simreel::golden {

/// Selects which baselines a run writes.
enum class Update {
  none,
  missing,  ///< writes baselines that do not exist
  changed,  ///< writes baselines that differ
  all,      ///< writes missing and changed baselines
  prune,    ///< writes no baselines; removes baselines that no test uses
};

}  // namespace simreel::golden
