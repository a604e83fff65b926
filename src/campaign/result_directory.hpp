#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "breccia/campaign/run.hpp"

namespace breccia {

/// The directory to which a run writes until its results are whole: that of the results, or its subdirectory
/// `unfinished` where earlier results stay until then. Brings a replacement to its end that was cut off, and removes
/// what a run that begins anew finds of one that has finished nothing.
/// Throws InputError where there is an objection to that (objection_to), and where files would be replaced that Breccia
/// did not write. Only the first process of a group may call it.
std::filesystem::path directory_to_run_in(const Study& study, const std::filesystem::path& directory,
                                          const RunOptions& options);

/// The same for a packing, which never removes finished tests: it goes on where those are of the same study, and throws
/// InputError where they are of another.
std::filesystem::path directory_to_pack_in(const Study& study, const std::filesystem::path& directory,
                                           const RunOptions& options);

/// Puts the results of a run into the place of earlier ones, if it has not written them there. Throws FileError.
void put_in_place(const Study& study, const std::filesystem::path& written, const std::filesystem::path& directory);

/// Brings to its end what a killed run of the study has left half done: results that were to take the place of earlier
/// ones. Throws FileError.
void finish_interrupted_replacement(const Study& study, const std::filesystem::path& directory);

/// What forbids that a run goes on from what is in a directory, or begins anew and replaces it; empty if nothing does.
std::string objection_to(const Study& study, const std::filesystem::path& directory, const RunOptions& options);

}  // namespace breccia
