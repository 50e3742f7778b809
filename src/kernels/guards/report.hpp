#pragma once
#include "kernels/guards/excuses.hpp"
#include "kernels/guards/place.hpp"
#include "kernels/shader/shader.hpp"
#include "kernels/spirv/module.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace simreel::kernels {

/// Name of the storage block of reports.
inline constexpr const char* reportBlock = "simreel_Report";

/// The source positions at which a kernel can cause a fault, and the code that records faults. An
/// invocation stores its first fault in private variables, at the cost of one comparison per access, and
/// adds it to the report block when the invocation ends. (llvmpipe executes both sides of every branch, so
/// an atomic operation at each access would be slow.)
class Report {
 public:
  explicit Report(const Files& files) : files_(files) {}
  [[nodiscard]] const Files& files() const { return files_; }

  /// Returns the index of a place. There is one place for each combination of kind, name, part and line.
  /// `what`: name in the user's source.
  std::uint32_t place(const char* kind, const std::string& what, const Position& at,
                      const std::string& part = {});
  /// Finds the values that a module uses only under conditions.
  void findExcuses(const Module& module) { excuses_ = excusesOf(module); }
  /// Makes note() ignore faults in the value `made` while the module does not use that value. Returns false
  /// for a value that is always used.
  bool excuse(Id made);
  /// Appends a call to `body` that records a fault unless `fine` is true. `minimum` and `greatest` are the
  /// values for words 2 and 3 of the place (see Place), signed or unsigned.
  void note(Module& module, std::vector<Instruction>& body, Id fine, std::uint32_t place, Id minimum,
            Id greatest);
  /// Does the same as note() for a place whose index is a run-time value.
  void noteAt(Module& module, std::vector<Instruction>& body, Id fine, Id place, Id minimum, Id greatest);
  /// Makes a module with calls of note() safe for SPIRV-Tools. Must be called before more calls are added
  /// to the optimized module.
  void hold(Module& module);
  /// Sets a function that the entry point calls before the kernel.
  void beginWith(Id function) { begin_ = function; }
  /// Appends the report functions, the report block, and an entry point that runs the kernel and then
  /// records its fault.
  void complete(Module& module);
  [[nodiscard]] const std::vector<Place>& places() const { return places_; }

 private:
  Id function(Module& module);
  void writeNote(Module& module, Id function, const Words& kept);
  void writeAddFault(Module& module, Id function, const Words& kept);
  void enter(Module& module, Id tell) const;

  const Files& files_;
  std::vector<Place> places_;
  Excuses excuses_;
  const std::vector<std::pair<Id, bool>>* excuse_ = nullptr;  ///< conditions of the current value; nullptr
                                                              ///< if it is always used
  const Module* known_ = nullptr;                             ///< module to which function_ belongs
  Id function_ = 0, begin_ = 0;
};

/// Emits the linear index of the running invocation in the whole dispatch: x fastest, then y, then z.
[[nodiscard]] Id linearInvocation(Module& module, std::vector<Instruction>& body);
/// Emits the linear index, in the dispatch, of another invocation of the same workgroup. `local` is the
/// index of that invocation in the workgroup.
[[nodiscard]] Id linearInvocation(Module& module, std::vector<Instruction>& body, Id local);

}  // namespace simreel::kernels
