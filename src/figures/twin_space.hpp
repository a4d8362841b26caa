#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns Figs 9 and 10: the digital twin space of the first seed, for each method of the grid
/// that infers (k, c). Columns:
/// method,kind,class,k_n_per_m,c_ns_per_m,k_to_n_per_m,c_to_ns_per_m,windows. `kind` is the type of
/// a row: a "bin" of the joint histogram, from and to; a "k-bin" or "c-bin" of its marginals; a
/// "known" window; a "generated" one (the first of each class); or, for simulated windows, the
/// "true" value of a known one.
Numbers twin_space(Source& source);

}  // namespace piae::figures
