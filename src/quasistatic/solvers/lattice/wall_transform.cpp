#include "quasistatic/solvers/lattice/wall_transform.hpp"

#include <cmath>
#include <numbers>

namespace breccia::quasistatic {
namespace {

using Complex = std::complex<double>;

/// Calls work(pair, distance of its partner) for all pairs. A row that is alone is its own partner.
template <class Work>
void for_pairs(const PairedRows& rows, const Work& work) {
  const std::size_t whole = rows.is_last_alone ? rows.pairs - 1 : rows.pairs;
  for (std::size_t pair = 0; pair < whole; ++pair) work(pair, rows.partner);
  if (whole < rows.pairs) work(whole, std::size_t{0});
}

/// A value of a pair of rows.
class PairedValue {
 public:
  PairedValue(const PairedRows& rows, std::size_t pair, std::size_t partner, std::size_t index) noexcept
      : value_(rows.first + pair * rows.distance + index * rows.apart), partner_(partner) {}

  [[nodiscard]] Complex get() const noexcept { return {value_[0], value_[partner_]}; }
  void set(const Complex& to) const noexcept {
    value_[partner_] = to.imag();
    value_[0] = to.real();
  }

 private:
  double* value_;
  std::size_t partner_;
};

/// The product of -i and a number.
Complex turned_back(const Complex& number) noexcept {
  return {number.imag(), -number.real()};
}

}  // namespace

WallTransform::WallTransform(Kind kind, int cells, std::size_t pairs)
    // The memory has a sum for each pair of rows behind the waves.
    : kind_(kind), cells_(static_cast<std::size_t>(cells)), pairs_(pairs), count_(cells_ + 1) {
  for (std::size_t j = 0; j < cells_; ++j) {
    const double angle = std::numbers::pi * static_cast<double>(j) / static_cast<double>(cells_);
    sines_.push_back(std::sin(angle));
    cosines_.push_back(std::cos(angle));
  }
  const int many = static_cast<int>(pairs_);
  transform_ = wave_transform(WaveDirection::backward,
                              {.length = cells, .rows = many, .apart = many, .apart_after = many, .is_in_place = true});
}

void WallTransform::apply(const PairedRows& rows, Complex* waves) const {
  auto* odd = waves + cells_ * pairs_;
  fold(rows, waves, odd);
  transform_->apply(waves, waves);
  unfold(rows, waves, odd);
}

/// Folds the even or odd continuation of the rows into one of half the length. `first_odd` receives half the odd wave
/// of the lowest number of even continuations.
void WallTransform::fold(const PairedRows& rows, Complex* waves, Complex* first_odd) const {
  const bool is_sine = kind_ == Kind::sine;
  for_pairs(rows, [&](std::size_t pair, std::size_t partner) {
    const auto begin = PairedValue(rows, pair, partner, 0).get(), end = PairedValue(rows, pair, partner, cells_).get();
    waves[pair] = is_sine ? 0.0 : 0.5 * (begin + end);
    first_odd[pair] = is_sine ? 0.0 : 0.5 * (begin - end);
  });
  for (std::size_t j = 1; j < cells_; ++j) {
    Complex* wave = waves + j * pairs_;
    const double sine = sines_[j], cosine = cosines_[j];
    const auto fold_at = [&](const auto& folded) {
      for_pairs(rows, [&](std::size_t pair, std::size_t partner) {
        wave[pair] =
            folded(pair, PairedValue(rows, pair, partner, j).get(), PairedValue(rows, pair, partner, cells_ - j).get());
      });
    };
    if (is_sine) {
      fold_at([&](std::size_t, const Complex& here, const Complex& there) {
        return sine * (here + there) + 0.5 * (here - there);
      });
    } else {
      fold_at([&](std::size_t pair, const Complex& here, const Complex& there) {
        first_odd[pair] += cosine * here;
        return 0.5 * (here + there) - sine * (here - there);
      });
    }
  }
}

/// The waves with even numbers are the waves of the folded rows, and differences of the waves with odd numbers are the
/// other waves.
void WallTransform::unfold(const PairedRows& rows, const Complex* waves, Complex* odd) const {
  const bool is_sine = kind_ == Kind::sine;
  for_pairs(rows, [&](std::size_t pair, std::size_t partner) {
    if (is_sine) odd[pair] = 0.5 * waves[pair];
    PairedValue(rows, pair, partner, 0).set(is_sine ? 0.0 : 2.0 * waves[pair]);
    PairedValue(rows, pair, partner, 1).set(2.0 * odd[pair]);
    if (is_sine) PairedValue(rows, pair, partner, cells_).set(0.0);
  });
  const std::size_t last = is_sine ? cells_ - 1 : cells_;
  for (std::size_t k = 1; 2 * k <= last; ++k) {
    const Complex *wave = waves + k * pairs_, *opposite = waves + (cells_ - k) * pairs_;
    for_pairs(rows, [&](std::size_t pair, std::size_t partner) {
      const Complex sum = wave[pair] + opposite[pair], difference = turned_back(wave[pair] - opposite[pair]);
      odd[pair] += 0.5 * (is_sine ? sum : difference);
      PairedValue(rows, pair, partner, 2 * k).set(is_sine ? difference : sum);
      if (2 * k + 1 <= last) PairedValue(rows, pair, partner, 2 * k + 1).set(2.0 * odd[pair]);
    });
  }
}

}  // namespace breccia::quasistatic
