#pragma once
#include "api/simreel/error.hpp"

#include <exception>
#include <string>

namespace simreel::api {

/// Throws the Error that corresponds to an exception of the program's internal functions.
[[noreturn]] void rethrowAsError(const std::exception_ptr& failure);

/// Throws an Error with one sentence.
[[noreturn]] void fail(ErrorKind kind, std::string message);

}  // namespace simreel::api
