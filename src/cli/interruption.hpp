#pragma once

namespace breccia::cli {

/// From now on SIGINT and SIGTERM ask the computation to stop at the next good moment.
void watch_for_interruption();

/// Has one of them arrived?
bool interruption_requested();

/// Throws Interrupted if so.
void stop_if_interrupted();

}  // namespace breccia::cli
