#include "breccia/parallel/ordered_values.hpp"

#include <cstring>
#include <numeric>

#include <mpi.h>

#include "parallel/communicator.hpp"
#include "parallel/session.hpp"

namespace breccia::parallel {
namespace {

constexpr int first_process = 0;

/// Joins lists of `bytes_each` a value, one from each process, in the order of the processes, on the first process.
void join(const void* own, std::size_t bytes_each, const std::vector<int>& counts, void* all) {
  MPI_Datatype value = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(bytes_each), MPI_BYTE, &value);
  MPI_Type_commit(&value);
  std::vector<int> begins(counts.size());
  std::exclusive_scan(counts.begin(), counts.end(), begins.begin(), 0);
  MPI_Gatherv(own, counts[static_cast<std::size_t>(rank())], value, all, counts.data(), begins.data(), value,
              first_process, communicator());
  MPI_Type_free(&value);
}

}  // namespace

bool is_collecting() noexcept {
  return rank() == first_process;
}

std::size_t OrderedPlaces::before(std::size_t place) const {
  std::size_t low = 0, high = count;
  while (low < high) {
    const auto middle = low + (high - low) / 2;
    if (place_of(middle) < place) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

OrderedPlaces consecutive_places(std::size_t first, std::size_t count) {
  return {count, [first](std::size_t i) { return first + i; }};
}

void collect_bytes(const std::byte* own, std::size_t bytes_each, const OrderedPlaces& places, std::size_t begin,
                   std::size_t end, std::byte* all) {
  const auto from = places.before(begin), to = places.before(end);
  const auto* const values = own + from * bytes_each;
  if (ranks() == 1) {
    if (to > from) std::memcpy(all, values, (to - from) * bytes_each);
    return;
  }
  std::vector<int> offsets;
  for (auto i = from; i < to; ++i) offsets.push_back(static_cast<int>(places.place_of(i) - begin));
  std::vector<int> counts(static_cast<std::size_t>(ranks()));
  counts[static_cast<std::size_t>(rank())] = static_cast<int>(offsets.size());
  MPI_Allgather(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, counts.data(), 1, MPI_INT, communicator());
  const auto received = is_collecting() ? end - begin : 0;
  std::vector<int> all_offsets(received);
  std::vector<std::byte> joined(received * bytes_each);
  join(offsets.data(), sizeof(int), counts, all_offsets.data());
  join(values, bytes_each, counts, joined.data());
  for (std::size_t i = 0; i < received; ++i) {
    std::memcpy(all + static_cast<std::size_t>(all_offsets[i]) * bytes_each, joined.data() + i * bytes_each,
                bytes_each);
  }
}

}  // namespace breccia::parallel
