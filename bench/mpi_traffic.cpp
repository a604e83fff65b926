// Counts the bytes that each process of an MPI program sends, for `LD_PRELOAD`: it stands before the functions of MPI
// and passes every call on (the profiling interface of MPI). When MPI ends, each process appends a line to the file
// that MPI_TRAFFIC names: its rank, bytes and messages to single processes, and bytes and calls of sums over all.
//
// Calls of C and C++ are counted, and so are all exchanges of Breccia and PETSc. MUMPS calls MPI from Fortran, whose
// functions do not pass here: its messages are left out.

#include <cstdio>
#include <cstdlib>
#include <unordered_map>

#include <mpi.h>

namespace {

struct Traffic {
  long bytes = 0, messages = 0;
  long reduced_bytes = 0, reductions = 0;
};

Traffic& traffic() {
  static Traffic counted;
  return counted;
}

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

void count_start(MPI_Request request) {
  const auto found = persistent().find(request);
  if (found != persistent().end()) count_message(found->second);
}

}  // namespace

extern "C" {

int MPI_Send(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm group) {
  count_message(size_of(count, type));
  return PMPI_Send(data, count, type, to, tag, group);
}

int MPI_Isend(const void* data, int count, MPI_Datatype type, int to, int tag, MPI_Comm group, MPI_Request* request) {
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
  count_start(*request);
  return PMPI_Start(request);
}

int MPI_Startall(int count, MPI_Request* requests) {
  for (int i = 0; i < count; ++i) count_start(requests[i]);
  return PMPI_Startall(count, requests);
}

int MPI_Request_free(MPI_Request* request) {
  persistent().erase(*request);
  return PMPI_Request_free(request);
}

int MPI_Sendrecv(const void* sent, int count, MPI_Datatype type, int to, int tag, void* received, int received_count,
                 MPI_Datatype received_type, int from, int received_tag, MPI_Comm group, MPI_Status* status) {
  count_message(size_of(count, type));
  return PMPI_Sendrecv(sent, count, type, to, tag, received, received_count, received_type, from, received_tag, group,
                       status);
}

int MPI_Alltoallv(const void* sent, const int* counts, const int* places, MPI_Datatype type, void* received,
                  const int* received_counts, const int* received_places, MPI_Datatype received_type, MPI_Comm group) {
  int processes = 0, own = 0;
  PMPI_Comm_size(group, &processes);
  PMPI_Comm_rank(group, &own);
  for (int to = 0; to < processes; ++to) {
    if (to != own && counts[to] > 0) count_message(size_of(counts[to], type));
  }
  return PMPI_Alltoallv(sent, counts, places, type, received, received_counts, received_places, received_type, group);
}

int MPI_Alltoallw(const void* sent, const int* counts, const int* places, const MPI_Datatype* types, void* received,
                  const int* received_counts, const int* received_places, const MPI_Datatype* received_types,
                  MPI_Comm group) {
  int processes = 0, own = 0;
  PMPI_Comm_size(group, &processes);
  PMPI_Comm_rank(group, &own);
  for (int to = 0; to < processes; ++to) {
    if (to != own && counts[to] > 0) count_message(size_of(counts[to], types[to]));
  }
  return PMPI_Alltoallw(sent, counts, places, types, received, received_counts, received_places, received_types, group);
}

int MPI_Allreduce(const void* given, void* reduced, int count, MPI_Datatype type, MPI_Op operation, MPI_Comm group) {
  traffic().reduced_bytes += size_of(count, type);
  ++traffic().reductions;
  return PMPI_Allreduce(given, reduced, count, type, operation, group);
}

int MPI_Finalize() {
  int rank = 0;
  PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (const char* name = std::getenv("MPI_TRAFFIC")) {
    if (std::FILE* file = std::fopen(name, "a")) {
      const auto& [bytes, messages, reduced_bytes, reductions] = traffic();
      std::fprintf(file, "%d %ld %ld %ld %ld\n", rank, bytes, messages, reduced_bytes, reductions);
      std::fclose(file);
    }
  }
  return PMPI_Finalize();
}

}  // extern "C"
