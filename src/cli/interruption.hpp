#pragma once

namespace breccia::cli {

/// Installs signal handlers: SIGINT, SIGTERM and, unless it is ignored, SIGHUP then request the computation to stop at
/// the next suitable point. On a terminal the first signal is answered at once, and a second SIGINT ends the program.
void watch_for_interruption();

/// Whether one of these signals has arrived.
bool interruption_requested();

/// Throws Interrupted if one of these signals has arrived.
void stop_if_interrupted();

}  // namespace breccia::cli
