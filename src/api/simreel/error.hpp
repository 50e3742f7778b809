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
  device,       ///< no device, a limit of the device, or a lost state (NaN) of a simulation
  different,    ///< a frame differs from the frame that Existing::resume kept
  inputOutput,  ///< a file cannot be read or written, or is damaged
  process,      ///< this process is a fork of a process that had a device open
  interrupted,  ///< Device::interrupt() or the hook of Device::whileWaiting() ended the call
  internal      ///< an error of the library
};

/// One mistake in a scene or in a user's kernel.
struct Mistake {
  std::string file;        ///< name of the file; empty for an override and for a scene given as text
                           ///< without a name
  int line = 0;            ///< line number, counted from 1; 0 if unknown
  int column = 0;          ///< column in code points, counted from 1; 0 if unknown
  std::string path;        ///< dotted path in the scene, such as "objects.flag.cloth.fabric"; empty if
                           ///< unknown
  std::string message;     ///< description of the mistake in one line
  std::string suggestion;  ///< name that was probably meant; empty if no name is similar
};

/// Exception that all functions of the library throw. what() returns the whole message. This is a sentence
/// or, for mistakes in a file, the report of the command line, with source lines and carets.
class SIMREEL_API Error : public std::exception {
 public:
  Error(ErrorKind kind, std::string message, std::vector<Mistake> mistakes = {});
  ~Error() override;
  Error(const Error&);
  Error& operator=(const Error&);
  [[nodiscard]] const char* what() const noexcept override;
  [[nodiscard]] ErrorKind kind() const noexcept;
  /// Returns every mistake, in the order of the file. For errors that do not concern a file's content,
  /// returns one mistake without a position if the message suggests a name, and otherwise an empty list.
  [[nodiscard]] const std::vector<Mistake>& mistakes() const noexcept;

 private:
  ErrorKind kind_;
  std::string message_;
  std::vector<Mistake> mistakes_;
};

}  // namespace simreel
