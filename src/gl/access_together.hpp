#pragma once

namespace simreel::gl {

/// Scope in which dispatches of typed kernels do not wait for each other (AccessLog), so that they run on
/// the device at the same time. A dispatch in the scope must not read data that another one in the scope
/// writes. All dispatches still wait for accesses from before the scope. Only one object may exist at a
/// time.
class AccessTogether {
 public:
  AccessTogether();
  ~AccessTogether();
  AccessTogether(const AccessTogether&) = delete;
  AccessTogether& operator=(const AccessTogether&) = delete;
};

}  // namespace simreel::gl
