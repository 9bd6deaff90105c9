// SPDX-License-Identifier: BSD-3-Clause

// Everything compiles after the macros that headers of Windows and <complex.h> leave behind.
// Source: rpcndr.h (small) and minwindef.h (near, far, IN, OUT) of the Windows SDK; C11, 7.3.1 (I).
#include <complex.h>

#include <algorithm>

#define small char
#define near
#define far
#define IN
#define OUT
#define interface struct

#include <pendular/laplace_young/law.hpp>
#include <pendular/pendular.hpp>

static_assert(pendular::check::capillary_law<pendular::capillary::richefeu>);
