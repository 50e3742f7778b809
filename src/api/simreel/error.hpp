#pragma once
#include <exception>
#include <simreel/export.hpp>
#include <string>
#include <vector>

namespace simreel {

/// Category of an Error.
enum class ErrorKind {
  scene,        ///< the scene has mistakes; see Error::mistakes()
  usage,        ///< a call has a wrong argument, or the scene does not allow it
  device,       ///< no device, a limit of the device, or a simulation lost its state (NaN)
  inputOutput,  ///< a file cannot be read or written
  process,      ///< this process is a fork of one that had a device open
  interrupted,  ///< Device::interrupt() or the hook of Device::whileWaiting() ended the call
  internal      ///< an error of the library
};

/// One mistake in a scene or in a user's kernel.
struct Mistake {
  std::string file;        ///< file; empty for an override and for a scene given as text without a name
  int line = 0;            ///< counted from 1; 0: unknown
  int column = 0;          ///< counted from 1, in code points; 0: unknown
  std::string path;        ///< dotted path in the scene: "objects.flag.cloth.fabric"; empty: unknown
  std::string message;     ///< one line
  std::string suggestion;  ///< name that was probably meant; empty: none is similar
};

/// Exception of all functions of the library. what() is the whole message: a sentence, or for mistakes in a
/// file the same report as the command line's, with source lines and carets.
class SIMREEL_API Error : public std::exception {
 public:
  Error(ErrorKind kind, std::string message, std::vector<Mistake> mistakes = {});
  ~Error() override;
  Error(const Error&);
  Error& operator=(const Error&);
  [[nodiscard]] const char* what() const noexcept override;
  [[nodiscard]] ErrorKind kind() const noexcept;
  /// Returns every mistake, in the order of the file. For errors about other things than a file's content:
  /// one mistake without a place if the message suggests a name, else none.
  [[nodiscard]] const std::vector<Mistake>& mistakes() const noexcept;

 private:
  ErrorKind kind_;
  std::string message_;
  std::vector<Mistake> mistakes_;
};

}  // namespace simreel
