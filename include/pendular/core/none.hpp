// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pendular {

/// The null policy of every axis: it plays no role and leaves no trace in the composed type.
struct none {};

}  // namespace pendular
