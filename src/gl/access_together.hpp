#pragma once

namespace simreel::gl {

/// Scope in which dispatches of typed kernels do not wait for each other (AccessLog), so that they run on
/// the device at the same time. No dispatch of the scope may read what another one writes. All still wait
/// for accesses from before the scope. Only one object may exist at a time.
class AccessTogether {
 public:
  AccessTogether();
  ~AccessTogether();
  AccessTogether(const AccessTogether&) = delete;
  AccessTogether& operator=(const AccessTogether&) = delete;
};

}  // namespace simreel::gl
