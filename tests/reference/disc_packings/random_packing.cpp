// Prints a random packing of discs of two sizes in a box of side 1:
//
//   random_packing BOX LARGE SMALL SIZE_RATIO AREA_FRACTION GAP SPREAD SEED
//
// BOX is periodic or walled; LARGE and SMALL are numbers of discs; GAP is the least distance of two surfaces, or of one
// and a wall, as a share of the smaller diameter.
// SPREAD makes it differ from pair to pair: it is the mean of two random shares, one a disc, from GAP to
// (1 + SPREAD) GAP. The discs start at random places; overlaps of the discs with their gaps are pushed apart until
// there are none, which leaves many pairs at the least gap.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

enum class Box { periodic, walled };

struct Request {
  Box box;
  int large, small;
  double size_ratio, area_fraction, gap, spread;
  unsigned seed;
};

struct Vector {
  double x, y;
};

double shortest_image(double distance) {
  return distance - std::round(distance);
}

double length(const Vector& vector) {
  return std::hypot(vector.x, vector.y);
}

class RandomPacking {
 public:
  explicit RandomPacking(const Request& request)
      : request_(request),
        small_diameter_(std::sqrt(4.0 * request.area_fraction / std::numbers::pi /
                                  (request.large * request.size_ratio * request.size_ratio + request.small))),
        gap_(request.gap * small_diameter_),
        diameters_(request.large, request.size_ratio * small_diameter_),
        gaps_(request.large + request.small, gap_ * (1.0 + margin)) {
    diameters_.resize(gaps_.size(), small_diameter_);
    std::mt19937_64 random(request.seed);
    // Not std::uniform_real_distribution, which may differ from library to library.
    const auto uniform = [&] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      const double x = uniform();
      const double y = uniform();
      centres_.push_back({x, y});
    }
    if (request.spread > 0.0) {
      for (double& gap : gaps_) gap *= 1.0 + request.spread * uniform();
    }
  }

  void push_apart() {
    constexpr int most_sweeps = 2'000'000;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      find_neighbours();
      std::vector<Vector> pushes(centres_.size(), Vector{0.0, 0.0});
      if (add_pushes(pushes) < 0.8 * margin * gap_) return;
      for (std::size_t i = 0; i < centres_.size(); ++i) {
        const double push = length(pushes[i]);
        const double longest = 0.1 * diameters_[i];
        const double factor = push > longest ? longest / push : 1.0;
        centres_[i].x += factor * pushes[i].x;
        centres_[i].y += factor * pushes[i].y;
      }
    }
    throw std::runtime_error("the discs cannot be pushed apart");
  }

  void print() {
    if (request_.box == Box::periodic) move_into_box();
    double least = 1.0;
    int near = 0;
    int near_walls = 0;
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      for (const double distance : to_walls(i)) {
        least = std::min(least, distance - diameters_[i] / 2.0);
        near_walls += distance - diameters_[i] / 2.0 < 1.01 * gap_ ? 1 : 0;
      }
      for (std::size_t j = i + 1; j < centres_.size(); ++j) {
        const double gap = length(between(centres_[i], centres_[j])) - (diameters_[i] + diameters_[j]) / 2.0;
        least = std::min(least, gap);
        near += gap < 1.01 * gap_ ? 1 : 0;
      }
    }
    std::printf(
        "# %s of side 1, made by random_packing: %d large and %d small discs, size ratio %g, fraction %g,\n"
        "# gap %g of the small diameter, spread %g, seed %u; least gap found %.6g, pairs below 1.01 of the gap: %d.\n",
        request_.box == Box::periodic ? "Periodic box" : "Box with walls", request_.large, request_.small,
        request_.size_ratio, request_.area_fraction, request_.gap, request_.spread, request_.seed,
        least / small_diameter_, near);
    if (request_.box == Box::walled) std::printf("# Gaps to walls below 1.01 of the gap: %d.\n", near_walls);
    std::printf("x,y,diameter\n");
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      std::printf("%.17g,%.17g,%.17g\n", centres_[i].x, centres_[i].y, diameters_[i]);
    }
  }

 private:
  static constexpr double margin = 5e-4;  // by which gaps are wider than the least gap, so that it is kept

  [[nodiscard]] Vector between(const Vector& from, const Vector& to) const {
    const Vector distance = {to.x - from.x, to.y - from.y};
    return request_.box == Box::walled ? distance : Vector{shortest_image(distance.x), shortest_image(distance.y)};
  }

  /// The distances of the centre of a disc to the walls, at the left, right, bottom and top.
  [[nodiscard]] std::vector<double> to_walls(std::size_t disc) const {
    if (request_.box == Box::periodic) return {};
    const auto& [x, y] = centres_[disc];
    return {x, 1.0 - x, y, 1.0 - y};
  }

  void move_into_box() {
    for (Vector& centre : centres_) {
      centre.x -= std::floor(centre.x);
      centre.y -= std::floor(centre.y);
    }
  }

  /// Lists for each disc those of higher number that may touch it, when the discs have moved since the last list.
  void find_neighbours() {
    const double skin = 0.3 * small_diameter_;
    double longest_move = 0.0;
    for (std::size_t i = 0; i < listed_.size(); ++i) {
      longest_move = std::max(longest_move, length(between(listed_[i], centres_[i])));
    }
    if (!listed_.empty() && longest_move <= skin / 2.0) return;
    listed_ = centres_;
    const double widest_gap = *std::ranges::max_element(gaps_);
    neighbours_.assign(centres_.size(), {});
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      for (std::size_t j = i + 1; j < centres_.size(); ++j) {
        const double reach = (diameters_[i] + diameters_[j]) / 2.0 + widest_gap + skin;
        if (length(between(centres_[i], centres_[j])) < reach) neighbours_[i].push_back(j);
      }
    }
  }

  /// Adds half of every overlap to the pushes of both discs, more to the smaller one; the largest overlap.
  double add_pushes(std::vector<Vector>& pushes) const {
    double largest = 0.0;
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      for (const std::size_t j : neighbours_[i]) {
        const Vector distance = between(centres_[i], centres_[j]);
        const double overlap = (diameters_[i] + diameters_[j]) / 2.0 + (gaps_[i] + gaps_[j]) / 2.0 - length(distance);
        if (overlap <= 0.0) continue;
        largest = std::max(largest, overlap);
        const double share =
            diameters_[j] * diameters_[j] / (diameters_[i] * diameters_[i] + diameters_[j] * diameters_[j]);
        const double scale = 0.5 * overlap / length(distance);
        pushes[i].x -= scale * share * distance.x;
        pushes[i].y -= scale * share * distance.y;
        pushes[j].x += scale * (1.0 - share) * distance.x;
        pushes[j].y += scale * (1.0 - share) * distance.y;
      }
      largest = std::max(largest, add_push_of_walls(i, pushes[i]));
    }
    return largest;
  }

  /// Adds half of every overlap with a wall to the push of a disc; the largest overlap.
  double add_push_of_walls(std::size_t disc, Vector& push) const {
    constexpr Vector inwards[] = {{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}};
    double largest = 0.0;
    const std::vector<double> distances = to_walls(disc);
    for (std::size_t wall = 0; wall < distances.size(); ++wall) {
      const double overlap = std::max(diameters_[disc] / 2.0 + gaps_[disc] - distances[wall], 0.0);
      largest = std::max(largest, overlap);
      push.x += 0.5 * overlap * inwards[wall].x;
      push.y += 0.5 * overlap * inwards[wall].y;
    }
    return largest;
  }

  Request request_;
  double small_diameter_, gap_;
  std::vector<double> diameters_, gaps_;
  std::vector<Vector> centres_, listed_;
  std::vector<std::vector<std::size_t>> neighbours_;
};

Box box_named(const std::string& name) {
  if (name == "periodic") return Box::periodic;
  if (name == "walled") return Box::walled;
  throw std::runtime_error("no box: " + name);
}

}  // namespace

int main(int count, char** words) {
  if (count != 9) {
    std::fputs("usage: random_packing BOX LARGE SMALL SIZE_RATIO AREA_FRACTION GAP SPREAD SEED\n", stderr);
    return 2;
  }
  try {
    RandomPacking packing({.box = box_named(words[1]),
                           .large = std::stoi(words[2]),
                           .small = std::stoi(words[3]),
                           .size_ratio = std::stod(words[4]),
                           .area_fraction = std::stod(words[5]),
                           .gap = std::stod(words[6]),
                           .spread = std::stod(words[7]),
                           .seed = static_cast<unsigned>(std::stoul(words[8]))});
    packing.push_apart();
    packing.print();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "random_packing: %s\n", error.what());
    return 1;
  }
}
