#include "parallel/machine.hpp"

#include <array>
#include <cstdint>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "parallel/communicator.hpp"
#include "parallel/session.hpp"

namespace breccia::parallel {
namespace {

constexpr int first_on_machine = 0;

/// An open file that is closed at the end.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) noexcept : descriptor_(descriptor) {}
  ~OpenFile() {
    if (is_open()) close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  OpenFile(OpenFile&&) = delete;
  OpenFile& operator=(OpenFile&&) = delete;

  [[nodiscard]] bool is_open() const noexcept { return descriptor_ >= 0; }
  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }

 private:
  int descriptor_;
};

/// Identity of a file on this machine, independent of its name: process and descriptor, device and number.
using FileIdentity = std::array<std::int64_t, 4>;

FileIdentity identity_of(int descriptor) {
  struct stat status {};
  if (descriptor < 0 || fstat(descriptor, &status) != 0) return {};
  return {getpid(), descriptor, static_cast<std::int64_t>(status.st_dev), static_cast<std::int64_t>(status.st_ino)};
}

/// Whether files may have this number of bytes: the system ends a program that makes them larger than its limit.
bool may_have(std::size_t bytes) {
  struct rlimit limit {};
  return getrlimit(RLIMIT_FSIZE, &limit) == 0 && (limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= bytes);
}

/// A file in memory of this number of bytes, without a name; -1 where the system has no such files, or not the memory.
int file_in_memory(std::size_t bytes) {
  if (!may_have(bytes)) return -1;
  const int descriptor = memfd_create("breccia", MFD_CLOEXEC);
  if (descriptor >= 0 && posix_fallocate(descriptor, 0, static_cast<off_t>(bytes)) != 0) {
    close(descriptor);
    return -1;
  }
  return descriptor;
}

/// The file of another process; -1 where the system does not allow it, or where the number of this process differs
/// between processes, as in a container of its own.
int file_of_other(const FileIdentity& identity) {
  const auto& [process, number, device, inode] = identity;
  if (process == 0) return -1;
  const auto path = "/proc/" + std::to_string(process) + "/fd/" + std::to_string(number);
  struct stat status {};
  const bool is_it = stat(path.c_str(), &status) == 0 && static_cast<std::int64_t>(status.st_dev) == device &&
                     static_cast<std::int64_t>(status.st_ino) == inode;
  return is_it ? open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOCTTY) : -1;
}

bool agree(bool is_well) {
  int all = is_well ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_INT, MPI_MIN, machine_communicator());
  return all == 1;
}

}  // namespace

int rank_on_machine() {
  if (!is_under_mpirun()) return 0;
  start();
  int rank = 0;
  MPI_Comm_rank(machine_communicator(), &rank);
  return rank;
}

int ranks_on_machine() {
  if (!is_under_mpirun()) return 1;
  start();
  int ranks = 1;
  MPI_Comm_size(machine_communicator(), &ranks);
  return ranks;
}

std::shared_ptr<std::byte> common_memory(std::size_t bytes) {
  // NOLINTNEXTLINE(modernize-avoid-c-arrays): of any length
  if (ranks_on_machine() == 1) return {new std::byte[bytes](), std::default_delete<std::byte[]>()};
  const bool is_first = rank_on_machine() == first_on_machine;
  const OpenFile made(is_first ? file_in_memory(bytes) : -1);
  auto identity = identity_of(made.descriptor());
  MPI_Bcast(identity.data(), static_cast<int>(identity.size()), MPI_INT64_T, first_on_machine, machine_communicator());
  const OpenFile opened(is_first ? -1 : file_of_other(identity));
  const int file = is_first ? made.descriptor() : opened.descriptor();
  void* memory = file < 0 ? MAP_FAILED : mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  // The first process keeps its file open until all processes have opened it.
  const bool is_common = agree(memory != MAP_FAILED);
  if (memory == MAP_FAILED) return nullptr;
  std::shared_ptr<std::byte> common(static_cast<std::byte*>(memory),
                                    [bytes](std::byte* mapped) { munmap(mapped, bytes); });
  return is_common ? common : nullptr;
}

}  // namespace breccia::parallel
