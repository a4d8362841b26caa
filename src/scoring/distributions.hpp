#pragma once

namespace piae::scoring {

// Distributions for statistics. Boost computes them; its headers take seconds to compile, so only
// one file includes them.

/// Returns the probability density of the standard normal distribution at z.
double normal_density(double z);
/// Return the probability that a standard normal number is below z, and above z.
double normal_below(double z);
double normal_above(double z);

/// Returns the value that Student's t with these degrees of freedom exceeds with the given
/// probability.
double student_t_exceeded_with(double probability, double degrees_of_freedom);

/// Returns the probability that Fisher's F with these degrees of freedom is above f.
double fisher_f_above(double f, double numerator_degrees, double denominator_degrees);

}  // namespace piae::scoring
