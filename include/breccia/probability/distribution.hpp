#pragma once

#include <string>
#include <variant>

namespace breccia {

/// A normal distribution.
struct Normal {
  double mean = 0.0;
  double deviation = 1.0;  ///< standard deviation, positive
};

/// A distribution whose logarithm is normal, of a quantity known within a factor: 68 % of it lies between
/// median / factor and median * factor.
struct LogNormal {
  double median = 1.0;  ///< positive
  double factor = 2.0;  ///< above 1
};

/// All values between two are equally likely.
struct Uniform {
  double from = 0.0;
  double to = 1.0;
};

/// All logarithms between those of two positive values are equally likely.
struct LogUniform {
  double from = 1.0;
  double to = 10.0;
};

/// What is known of an uncertain number, in SI units. A score z stands for the value that is above a share Phi(z) of
/// the distribution, where Phi is the standard normal distribution: the score of an uncertain number is a standard
/// normal variable, whatever its distribution.
using Distribution = std::variant<Normal, LogNormal, Uniform, LogUniform>;

/// The value with a score.
double value_at_score(const Distribution& distribution, double score);
/// The score of a value; infinite at the ends of a uniform distribution and beyond them.
double score_of(const Distribution& distribution, double value);
/// The value that is as often exceeded as not.
double median(const Distribution& distribution);

/// The largest score, above or below zero, that is expected of an uncertain number: 6 of 100 000 values are beyond.
inline constexpr double most_score = 4.0;

/// What is wrong with the parameters of a distribution, in words: "expected a positive standard deviation, got 0";
/// empty for a sound one.
std::string mistake_in(const Distribution& distribution);

/// The share of a standard normal variable below a score, Phi(z).
double normal_share(double score);
/// The score below which a share of a standard normal variable lies; infinite for the shares 0 and 1.
double normal_score(double share);
/// The number below which a share of Student's t lies, with 3 degrees of freedom or more, to 1 % (the expansion of
/// Fisher and Cornish, Abramowitz and Stegun, Eq. 26.7.5).
double student_score(double share, double degrees);

}  // namespace breccia
