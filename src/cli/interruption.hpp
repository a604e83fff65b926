#pragma once

namespace breccia::cli {

/// Installs handlers by which SIGINT and SIGTERM request the computation to stop at the next suitable point.
void watch_for_interruption();

/// Whether one of these signals has arrived.
bool interruption_requested();

/// Throws Interrupted if one of these signals has arrived.
void stop_if_interrupted();

}  // namespace breccia::cli
