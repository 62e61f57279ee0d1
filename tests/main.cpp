#define BOOST_TEST_MODULE springcheck
#include <boost/test/unit_test.hpp>
