// SPDX-License-Identifier: BSD-3-Clause
// What the list of all laws may take from elsewhere.
#include "law.cpp"

#include <boost/hana/tuple.hpp>
#include <boost/hana/type.hpp>
