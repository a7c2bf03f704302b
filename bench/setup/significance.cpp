#include "bench/setup/significance.h"

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace bench {

using boost::math::complement;

double z_for(double alpha) {
    return quantile(complement(boost::math::normal(), alpha / 2));
}

double student_tail(double t, int degrees_of_freedom) {
    return 2 * cdf(complement(boost::math::students_t(degrees_of_freedom), t));
}

double t_for(double alpha, int degrees_of_freedom) {
    return quantile(complement(boost::math::students_t(degrees_of_freedom), alpha / 2));
}

}  // namespace bench
