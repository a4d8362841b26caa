#pragma once

#include "figures/numbers.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Figs 9 and 10: the digital twin space of the first seed, of each method of the grid that infers
/// (k, c). Columns: method,kind,class,k_n_per_m,c_ns_per_m,k_to_n_per_m,c_to_ns_per_m,windows.
/// `kind` says what a row is: a "bin" of the joint histogram, from and to, or a "k-bin" or "c-bin"
/// of its marginals; a "known" window, a "generated" one (the first of each class), or, where
/// windows are simulated, the "true" value of a known one.
Numbers twin_space(Source& source);

}  // namespace piae::figures
