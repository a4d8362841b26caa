#include "scoring/distributions.hpp"

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace piae::scoring {

using boost::math::complement;

double normal_density(double z) { return pdf(boost::math::normal(), z); }

double normal_below(double z) { return cdf(boost::math::normal(), z); }

double normal_above(double z) { return cdf(complement(boost::math::normal(), z)); }

double student_t_exceeded_with(double probability, double degrees_of_freedom) {
  return quantile(complement(boost::math::students_t(degrees_of_freedom), probability));
}

double fisher_f_above(double f, double numerator_degrees, double denominator_degrees) {
  return cdf(complement(boost::math::fisher_f(numerator_degrees, denominator_degrees), f));
}

}  // namespace piae::scoring
