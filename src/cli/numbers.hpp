#pragma once

#include "cli/app.hpp"

namespace piae::cli {

/// Checks for CLI11 that, unlike its own, refuse NaN and infinity and say in words what would do.
CLI::Validator positive_number();
CLI::Validator non_negative_number();
CLI::Validator share();           ///< from 0 to 1
CLI::Validator natural_number();  ///< 0, 1, 2, ...

}  // namespace piae::cli
