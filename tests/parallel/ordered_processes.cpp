// A test under mpirun: the values of a lattice, of which each process except the last has a part of each row, are
// collected, written to a state and read from it in the order of the lattice. Sums are taken in the order of the
// processes, and the first process with the largest value is found.
//
//   ordered_processes DIRECTORY

#include <cstdio>
#include <filesystem>
#include <span>
#include <vector>

#include "breccia/parallel/ordered_values.hpp"

#include "checkpoint/state.hpp"
#include "parallel/reduction.hpp"
#include "parallel/session.hpp"

namespace {

namespace parallel = breccia::parallel;

constexpr std::size_t in_row = 7, rows = 200'003;  // more than one piece of values

/// Prints the mistake unless the condition is true.
bool expect(bool holds, const char* wrong) {
  if (!holds) std::puts(wrong);
  return holds;
}

double value_at(std::size_t place) {
  return 0.5 + static_cast<double>(place);
}

/// The places of the values of one of the processes that have values: some columns of all rows.
parallel::OrderedPlaces places_of(std::size_t process, std::size_t processes) {
  const auto first = in_row * process / processes, size = in_row * (process + 1) / processes - first;
  return {size * rows, [=](std::size_t value) { return value / size * in_row + first + value % size; }};
}

bool is_whole(const std::vector<double>& values, std::size_t begin) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != value_at(begin + i)) return false;
  }
  return true;
}

/// Adds a small number to a large sum on each process, where it is lost by rounding, and subtracts the large number on
/// the last process: in another order of the processes the sum would differ.
bool adds_in_order(bool is_first, bool is_last) {
  constexpr double large = 0x1p60;
  std::vector<double> sums(2);
  parallel::sum_in_order(sums, [&](std::span<double> so_far) {
    if (is_first) so_far[0] += large;
    so_far[0] += 1.0;
    if (is_last) so_far[0] -= large;
    so_far[1] += 1.0;
  });
  return sums == std::vector{0.0, static_cast<double>(parallel::ranks())};
}

}  // namespace

int main(int, char** arguments) {
  parallel::start();
  const auto process = static_cast<std::size_t>(parallel::rank()), all = static_cast<std::size_t>(parallel::ranks());
  const auto places = process + 1 < all ? places_of(process, all - 1) : parallel::OrderedPlaces();
  std::vector<double> own;
  for (std::size_t i = 0; i < places.count; ++i) own.push_back(value_at(places.place_of(i)));

  bool holds = true;
  std::size_t pieces = 0;
  parallel::for_each_piece(in_row * rows, [&](std::size_t begin, std::size_t end) {
    const auto piece = parallel::collect(std::span<const double>(own), places, begin, end);
    holds = expect(piece.size() == (process == 0 ? end - begin : 0), "a piece has another size") && holds;
    holds = expect(is_whole(piece, begin), "a piece is not in order") && holds;
    ++pieces;
  });
  holds = expect(pieces == 2, "not as many pieces as meant") && holds;

  holds = expect(adds_in_order(process == 0, process + 1 == all), "sums are not in order") && holds;
  // All processes except the first have the largest value.
  holds =
      expect(parallel::is_first_largest(process == 0 ? 1.0 : 2.0) == (process == 1), "another has the largest value") &&
      holds;

  const auto path = std::filesystem::path(arguments[1]) / "state.h5";
  breccia::StateWriter writer(path, {"deck", "version"});
  writer.write("/values", own, places, in_row * rows);
  writer.commit();
  static_cast<void>(parallel::gather({}));  // the first process has written
  const breccia::StateReader reader(path);
  std::vector<double> again(own.size());
  reader.read("/values", again, places, in_row * rows);
  holds = expect(again == own, "a state gives other values back") && holds;
  holds = expect(is_whole(reader.numbers("/values"), 0), "a state is not in order") && holds;
  parallel::stop();
  return holds ? 0 : 1;
}
