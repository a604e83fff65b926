#pragma once

#include <string_view>

namespace breccia::cli {

/// A description of the build, which CMake writes into the program.
struct BuildInformation {
  std::string_view commit;  ///< commit of the git repository, with -dirty after changes; empty outside of a repository
  std::string_view compiler;   ///< name and version of the compiler
  std::string_view type;       ///< the build type of CMake, such as Release
  std::string_view processor;  ///< the processor family that the program was compiled for, such as x86_64
  std::string_view libraries;  ///< names and versions of the libraries, with commas between them
};

BuildInformation build_information();

}  // namespace breccia::cli
