#pragma once

namespace breccia::cli {

/// How much a command prints.
enum class Detail {
  brief,  ///< a line for each calculation, tables of the stages that no other stage builds upon
  full    ///< the numerical errors of each calculation, tables of all stages, the names of all files
};

}  // namespace breccia::cli
