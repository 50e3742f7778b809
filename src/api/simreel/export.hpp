#pragma once

/// Marks a declaration as part of libsimreel's interface. Everything else in the library is hidden.
#define SIMREEL_API __attribute__((visibility("default")))
