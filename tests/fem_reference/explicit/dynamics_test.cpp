#define BOOST_TEST_MODULE fem_explicit_dynamics
#include "fem_reference/explicit/explicit_dynamics.hpp"

#include <boost/test/unit_test.hpp>
BOOST_AUTO_TEST_CASE(placeholder) {}
