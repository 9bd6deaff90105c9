// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "job.hpp"
#include "wet_options.hpp"

#include <CLI/CLI.hpp>

#include <string>

namespace examples {

/// A number above 0.
extern const CLI::Validator positive;

void describe(CLI::App& app, job_options& o);
/// To be called first: of an option given twice the later one counts from here on.
void describe(CLI::App& app, wet_options& o);

/// Errors: prints one sentence and ends the program with a code that is not 0.
void parse(CLI::App& app, const std::string& program, int count, char** arguments);

}  // namespace examples
