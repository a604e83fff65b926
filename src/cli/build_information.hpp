#pragma once

#include <string_view>

namespace breccia::cli {

/// How the program was built, as CMake writes it into the program.
struct BuildInformation {
  std::string_view commit;     ///< of the git repository, with -dirty after changes; empty outside of one
  std::string_view compiler;   ///< name and version
  std::string_view type;       ///< the build type of CMake, such as Release
  std::string_view processor;  ///< the family it was compiled for, such as x86_64
  std::string_view libraries;  ///< name and version of each, with commas between them
};

BuildInformation build_information();

}  // namespace breccia::cli
