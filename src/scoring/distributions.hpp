#pragma once

namespace piae::scoring {

// The distributions that statistics need. Boost computes them; its headers take seconds to compile,
// so one file alone includes them.

/// The probability density of the standard normal distribution at z.
double normal_density(double z);
/// The probability that a standard normal number is below z, and that it is above.
double normal_below(double z);
double normal_above(double z);

/// What Student's t with these degrees of freedom exceeds with the given probability.
double student_t_exceeded_with(double probability, double degrees_of_freedom);

/// The probability that Fisher's F with these degrees of freedom is above f.
double fisher_f_above(double f, double numerator_degrees, double denominator_degrees);

}  // namespace piae::scoring
