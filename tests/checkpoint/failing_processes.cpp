// A test under mpirun: a damaged checkpoint is found by all processes, and a checkpoint that cannot be written ends all
// of them.
//   failing_processes DIRECTORY

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

#include "breccia/error.hpp"

#include "checkpoint/checkpoint.hpp"
#include "parallel/reduction.hpp"
#include "parallel/session.hpp"

namespace {

namespace parallel = breccia::parallel;

constexpr std::chrono::milliseconds later(300);

/// Whether the message about the damaged file is returned on this process, which may not be the first one.
bool is_told_of_damage(const std::filesystem::path& path) {
  if (parallel::rank() == 0) std::ofstream(path) << "of another program";
  static_cast<void>(parallel::largest(0.0));
  if (parallel::rank() > 0) std::this_thread::sleep_for(later);
  breccia::Checkpoint checkpoint(path, {"deck", "version"}, {});
  return checkpoint.look_for_earlier().size() == 1;
}

/// Whether this process fails where only the first one writes.
bool fails_to_write(const std::filesystem::path& path) {
  breccia::Checkpoint checkpoint(path, {"deck", "version"}, {});
  try {
    checkpoint.save([](breccia::StateWriter& state) {
      state.write("/number", 1.0);
      state.write("/sum", parallel::sum(1.0));
    });
  } catch (const breccia::FileError&) {
    return true;
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path directory(argv[1]);
  parallel::start();
  const bool is_told = is_told_of_damage(directory / "damaged.checkpoint.h5");
  if (!is_told) std::printf("process %d is not told of a damaged checkpoint\n", parallel::rank());
  const bool fails = fails_to_write(directory / "missing" / "a.checkpoint.h5");
  if (!fails) std::printf("process %d goes on without its checkpoint\n", parallel::rank());
  const bool is_several = parallel::ranks() > 1;
  parallel::stop();
  return is_told && fails && is_several ? 0 : 1;
}
