// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pendular {

/// The null policy of every role, whatever name it has there: it plays no role, whatever its place among the others.
struct none {};

}  // namespace pendular
