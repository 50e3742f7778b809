#pragma once

/// Marks what libsimreel offers; everything else of the library is hidden.
#define SIMREEL_API __attribute__((visibility("default")))
