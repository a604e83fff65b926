#include "films/solver/elimination_order.hpp"

#include <array>
#include <csignal>
#include <cstddef>
#include <cstdint>

#include <fmt/format.h>
#include <metis.h>

#include "breccia/error.hpp"

namespace breccia::films {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

/// Spreads the number of an unknown over 64 bits (the finaliser of MurmurHash3).
std::uint64_t spread(std::uint64_t x) {
  x = (x ^ (x >> 33U)) * 0xff51afd7ed558ccdULL;
  x = (x ^ (x >> 33U)) * 0xc4ceb9fe1a85ec53ULL;
  return x ^ (x >> 33U);
}

template <class Visit>
void for_each_pair(const Sparse& lower_triangle, const Visit& visit) {
  for (int column = 0; column < lower_triangle.outerSize(); ++column) {
    for (Sparse::InnerIterator at(lower_triangle, column); at; ++at) {
      if (at.row() > column) visit(static_cast<int>(at.row()), column);
    }
  }
}

/// The first unknown of each vertex of the graph. A vertex consists of the unknowns from its first one up to the first
/// one of the next vertex.
std::vector<int> first_unknowns(const Sparse& lower_triangle) {
  const auto count = static_cast<std::size_t>(lower_triangle.rows());
  // Unknowns with equal sums have the same neighbours, among which each counts itself.
  std::vector<std::uint64_t> neighbours(count);
  for (std::size_t i = 0; i < count; ++i) neighbours[i] = spread(i + 1);  // spread(0) is 0 and would not count
  for_each_pair(lower_triangle, [&](int row, int column) {
    neighbours[static_cast<std::size_t>(row)] += spread(static_cast<std::uint64_t>(column) + 1);
    neighbours[static_cast<std::size_t>(column)] += spread(static_cast<std::uint64_t>(row) + 1);
  });
  std::vector<int> first;
  for (std::size_t i = 0; i < count; ++i) {
    if (i == 0 || neighbours[i] != neighbours[i - 1]) first.push_back(static_cast<int>(i));
  }
  first.push_back(static_cast<int>(count));
  return first;
}

/// Vertices with their sizes, and the neighbours of each in compressed rows.
struct Graph {
  std::vector<idx_t> sizes, first_neighbour, neighbours;
};

Graph graph_of(const Sparse& lower_triangle, const std::vector<int>& first) {
  const std::size_t vertices = first.size() - 1;
  std::vector<int> vertex(static_cast<std::size_t>(first.back()));
  Graph graph;
  for (std::size_t v = 0; v < vertices; ++v) {
    graph.sizes.push_back(first[v + 1] - first[v]);
    for (int i = first[v]; i < first[v + 1]; ++i) vertex[static_cast<std::size_t>(i)] = static_cast<int>(v);
  }
  // The first unknown of a vertex has the same neighbours as its other unknowns.
  const auto for_each_edge = [&](const auto& visit) {
    for_each_pair(lower_triangle, [&](int row, int column) {
      const int a = vertex[static_cast<std::size_t>(row)], b = vertex[static_cast<std::size_t>(column)];
      if (a != b && first[static_cast<std::size_t>(a)] == row && first[static_cast<std::size_t>(b)] == column) {
        visit(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
      }
    });
  };
  graph.first_neighbour.assign(vertices + 1, 0);
  for_each_edge([&](std::size_t a, std::size_t b) {
    ++graph.first_neighbour[a + 1];
    ++graph.first_neighbour[b + 1];
  });
  for (std::size_t v = 0; v < vertices; ++v) graph.first_neighbour[v + 1] += graph.first_neighbour[v];
  graph.neighbours.resize(static_cast<std::size_t>(graph.first_neighbour.back()));
  auto next = graph.first_neighbour;
  for_each_edge([&](std::size_t a, std::size_t b) {
    graph.neighbours[static_cast<std::size_t>(next[a]++)] = static_cast<idx_t>(b);
    graph.neighbours[static_cast<std::size_t>(next[b]++)] = static_cast<idx_t>(a);
  });
  return graph;
}

/// METIS replaces the handlers of the signals that end a process. These signals wait while it works, and have their own
/// handlers again afterwards.
class OwnSignals {
 public:
  OwnSignals() {
    sigset_t ending;
    sigemptyset(&ending);
    sigaddset(&ending, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &ending, &blocked_before_);
    sigaction(SIGTERM, nullptr, &of_termination_);
    sigaction(SIGABRT, nullptr, &of_abort_);
  }
  ~OwnSignals() {
    sigaction(SIGTERM, &of_termination_, nullptr);
    sigaction(SIGABRT, &of_abort_, nullptr);
    pthread_sigmask(SIG_SETMASK, &blocked_before_, nullptr);
  }
  OwnSignals(const OwnSignals&) = delete;
  OwnSignals& operator=(const OwnSignals&) = delete;
  OwnSignals(OwnSignals&&) = delete;
  OwnSignals& operator=(OwnSignals&&) = delete;

 private:
  sigset_t blocked_before_{};
  struct sigaction of_termination_ {};
  struct sigaction of_abort_ {};
};

}  // namespace

std::vector<int> elimination_order(const Sparse& lower_triangle) {
  const auto first = first_unknowns(lower_triangle);
  auto graph = graph_of(lower_triangle, first);
  auto vertices = static_cast<idx_t>(graph.sizes.size());
  std::vector<idx_t> vertex_at(graph.sizes.size()), position(graph.sizes.size());
  std::array<idx_t, METIS_NOPTIONS> options{};
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_COMPRESS] = 0;
  const int result = [&] {
    const OwnSignals signals;
    return METIS_NodeND(&vertices, graph.first_neighbour.data(), graph.neighbours.data(), graph.sizes.data(),
                        options.data(), vertex_at.data(), position.data());
  }();
  if (result == METIS_ERROR_MEMORY) {
    throw NumericalError("films: memory has run out while the unknowns were ordered; fewer grains take less");
  }
  if (result != METIS_OK)
    throw NumericalError(fmt::format("films: the unknowns cannot be ordered (METIS: {})", result));
  std::vector<int> positions(static_cast<std::size_t>(first.back()));
  int next = 0;
  for (const auto vertex : vertex_at) {
    const auto v = static_cast<std::size_t>(vertex);
    for (int i = first[v]; i < first[v + 1]; ++i) positions[static_cast<std::size_t>(i)] = next++;
  }
  return positions;
}

}  // namespace breccia::films
