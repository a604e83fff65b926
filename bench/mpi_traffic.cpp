// Counts the messages that each process of an MPI program sends, and the processor time that it spends in MPI, most of
// it waiting. The library is for `LD_PRELOAD`: its functions replace those of MPI and pass every call on (the profiling
// interface of MPI). When MPI ends, each process appends a line to the file that MPI_TRAFFIC names: its rank, bytes and
// messages to single processes, bytes and calls of sums over all, and the processor time in MPI [s].
//
// The messages of C and C++ are counted, among them all exchanges of Breccia and PETSc. MUMPS calls MPI from Fortran:
// the time that it waits is counted, its messages are not.

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <unordered_map>

#include <mpi.h>

namespace {

struct Traffic {
  long bytes = 0, messages = 0;
  long reduced_bytes = 0, reductions = 0;
  double seconds = 0.0;
};

Traffic& traffic() {
  static Traffic counted;
  return counted;
}

double processor_seconds() {
  constexpr double nanosecond = 1e-9;
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + nanosecond * static_cast<double>(now.tv_nsec);
}

/// Adds the processor time between its construction and destruction to that of MPI.
class InMpi {
 public:
  InMpi() = default;
  InMpi(const InMpi&) = delete;
  InMpi& operator=(const InMpi&) = delete;
  InMpi(InMpi&&) = delete;
  InMpi& operator=(InMpi&&) = delete;
  ~InMpi() { traffic().seconds += processor_seconds() - begin_; }

 private:
  double begin_ = processor_seconds();
};

/// Bytes of each persistent request to send, which is started many times.
std::unordered_map<MPI_Request, long>& persistent() {
  static std::unordered_map<MPI_Request, long> bytes;
  return bytes;
}

long size_of(int count, MPI_Datatype type) {
  int size = 0;
  PMPI_Type_size(type, &size);
  return static_cast<long>(size) * count;
}

void count_message(long bytes) {
  traffic().bytes += bytes;
  ++traffic().messages;
}

/// Counts the messages to all other processes.
template <class BytesTo>
void count_messages(MPI_Comm group, const BytesTo& bytes_to) {
  int processes = 0, own = 0;
  PMPI_Comm_size(group, &processes);
  PMPI_Comm_rank(group, &own);
  for (int to = 0; to < processes; ++to) {
    if (const long bytes = bytes_to(to); to != own && bytes > 0) count_message(bytes);
  }
}

void count_start(MPI_Request request) {
  const auto found = persistent().find(request);
  if (found != persistent().end()) count_message(found->second);
}

}  // namespace

extern "C" {

int MPI_Send(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm group) {
  const InMpi inside;
  count_message(size_of(count, type));
  return PMPI_Send(data, count, type, to, tag, group);
}

int MPI_Isend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm group, MPI_Request* request) {
  const InMpi inside;
  count_message(size_of(count, type));
  return PMPI_Isend(data, count, type, to, tag, group, request);
}

int MPI_Send_init(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm group,
                  MPI_Request* request) {
  const int error = PMPI_Send_init(data, count, type, to, tag, group, request);
  persistent()[*request] = size_of(count, type);
  return error;
}

int MPI_Start(MPI_Request* request) {
  const InMpi inside;
  count_start(*request);
  return PMPI_Start(request);
}

int MPI_Startall(int count, MPI_Request* requests) {
  const InMpi inside;
  for (int i = 0; i < count; ++i) count_start(requests[i]);
  return PMPI_Startall(count, requests);
}

int MPI_Request_free(MPI_Request* request) {
  persistent().erase(*request);
  return PMPI_Request_free(request);
}

int MPI_Sendrecv(const void* sent, int count, MPI_Datatype type, int to, int tag, void* received, int received_count,
                 MPI_Datatype received_type, int from, int received_tag, MPI_Comm group, MPI_Status* status) {
  const InMpi inside;
  count_message(size_of(count, type));
  return PMPI_Sendrecv(sent, count, type, to, tag, received, received_count, received_type, from, received_tag, group,
                       status);
}

int MPI_Alltoallv(const void* sent, const int* counts, const int* places, MPI_Datatype type, void* received,
                  const int* received_counts, const int* received_places, MPI_Datatype received_type, MPI_Comm group) {
  const InMpi inside;
  count_messages(group, [&](int to) { return size_of(counts[to], type); });
  return PMPI_Alltoallv(sent, counts, places, type, received, received_counts, received_places, received_type, group);
}

int MPI_Alltoallw(const void* sent, const int* counts, const int* places, const MPI_Datatype* types, void* received,
                  const int* received_counts, const int* received_places, const MPI_Datatype* received_types,
                  MPI_Comm group) {
  const InMpi inside;
  count_messages(group, [&](int to) { return size_of(counts[to], types[to]); });
  return PMPI_Alltoallw(sent, counts, places, types, received, received_counts, received_places, received_types, group);
}

int MPI_Allreduce(const void* given, void* reduced, int count, MPI_Datatype type, MPI_Op operation, MPI_Comm group) {
  const InMpi inside;
  traffic().reduced_bytes += size_of(count, type);
  ++traffic().reductions;
  return PMPI_Allreduce(given, reduced, count, type, operation, group);
}

int MPI_Recv(void* data, int count, MPI_Datatype type, int from, int tag, MPI_Comm group, MPI_Status* status) {
  const InMpi inside;
  return PMPI_Recv(data, count, type, from, tag, group, status);
}

int MPI_Wait(MPI_Request* request, MPI_Status* status) {
  const InMpi inside;
  return PMPI_Wait(request, status);
}

int MPI_Waitall(int count, MPI_Request* requests, MPI_Status* statuses) {
  const InMpi inside;
  return PMPI_Waitall(count, requests, statuses);
}

int MPI_Waitany(int count, MPI_Request* requests, int* index, MPI_Status* status) {
  const InMpi inside;
  return PMPI_Waitany(count, requests, index, status);
}

int MPI_Barrier(MPI_Comm group) {
  const InMpi inside;
  return PMPI_Barrier(group);
}

int MPI_Bcast(void* data, int count, MPI_Datatype type, int root, MPI_Comm group) {
  const InMpi inside;
  return PMPI_Bcast(data, count, type, root, group);
}

int MPI_Gatherv(const void* sent, int count, MPI_Datatype type, void* received, const int* counts, const int* places,
                MPI_Datatype received_type, int root, MPI_Comm group) {
  const InMpi inside;
  return PMPI_Gatherv(sent, count, type, received, counts, places, received_type, root, group);
}

int MPI_Allgather(const void* sent, int count, MPI_Datatype type, void* received, int received_count,
                  MPI_Datatype received_type, MPI_Comm group) {
  const InMpi inside;
  return PMPI_Allgather(sent, count, type, received, received_count, received_type, group);
}

// The functions in which MUMPS waits, by their names in Fortran.
// NOLINTBEGIN(readability-identifier-naming)

using Integer = MPI_Fint;

void pmpi_recv_(void*, Integer*, Integer*, Integer*, Integer*, Integer*, Integer*, Integer*);
void mpi_recv_(void* data, Integer* count, Integer* type, Integer* from, Integer* tag, Integer* group, Integer* status,
               Integer* error) {
  const InMpi inside;
  pmpi_recv_(data, count, type, from, tag, group, status, error);
}

void pmpi_probe_(Integer*, Integer*, Integer*, Integer*, Integer*);
void mpi_probe_(Integer* from, Integer* tag, Integer* group, Integer* status, Integer* error) {
  const InMpi inside;
  pmpi_probe_(from, tag, group, status, error);
}

void pmpi_iprobe_(Integer*, Integer*, Integer*, Integer*, Integer*, Integer*);
void mpi_iprobe_(Integer* from, Integer* tag, Integer* group, Integer* is_there, Integer* status, Integer* error) {
  const InMpi inside;
  pmpi_iprobe_(from, tag, group, is_there, status, error);
}

void pmpi_wait_(Integer*, Integer*, Integer*);
void mpi_wait_(Integer* request, Integer* status, Integer* error) {
  const InMpi inside;
  pmpi_wait_(request, status, error);
}

void pmpi_barrier_(Integer*, Integer*);
void mpi_barrier_(Integer* group, Integer* error) {
  const InMpi inside;
  pmpi_barrier_(group, error);
}

void pmpi_bcast_(void*, Integer*, Integer*, Integer*, Integer*, Integer*);
void mpi_bcast_(void* data, Integer* count, Integer* type, Integer* root, Integer* group, Integer* error) {
  const InMpi inside;
  pmpi_bcast_(data, count, type, root, group, error);
}

void pmpi_allreduce_(void*, void*, Integer*, Integer*, Integer*, Integer*, Integer*);
void mpi_allreduce_(void* given, void* reduced, Integer* count, Integer* type, Integer* operation, Integer* group,
                    Integer* error) {
  const InMpi inside;
  pmpi_allreduce_(given, reduced, count, type, operation, group, error);
}
// NOLINTEND(readability-identifier-naming)

int MPI_Finalize() {
  int rank = 0;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (const char* name = std::getenv("MPI_TRAFFIC")) {
    if (std::FILE* file = std::fopen(name, "a")) {
      const auto& [bytes, messages, reduced_bytes, reductions, seconds] = traffic();
      std::fprintf(file, "%d %ld %ld %ld %ld %.3f\n", rank, bytes, messages, reduced_bytes, reductions, seconds);
      std::fclose(file);
    }
  }
  return PMPI_Finalize();
}

}  // extern "C"
