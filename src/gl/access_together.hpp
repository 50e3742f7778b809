#pragma once

namespace simreel::gl {

/// While it lives, dispatches of typed kernels do not wait for each other (AccessLog): they share the
/// device, and none reads what another one writes. They wait for what was before. One at a time.
class AccessTogether {
 public:
  AccessTogether();
  ~AccessTogether();
  AccessTogether(const AccessTogether&) = delete;
  AccessTogether& operator=(const AccessTogether&) = delete;
};

}  // namespace simreel::gl
