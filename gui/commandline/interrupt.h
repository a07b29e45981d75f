#pragma once
// Ctrl-C: the running job is cancelled; if that takes longer than a moment, the process ends at once. Output files are
// written beside their final names, so nothing half-written is ever left under them.

#include "core/math/parallel.h"

namespace glint::gui {

inline constexpr int k_interrupted_status = 130;

/// Installs the handler for the life of the process; `control` must live as long. Call once, from main.
void cancel_on_interrupt(JobControl& control);

}  // namespace glint::gui
