#pragma once

#include <vector>

#include "figures/picture.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Windows of a fault that is known in one condition and tested in another, of the first seed; a
/// picture for each fault class. The sets of windows are, in this order: the known ones (C) of each
/// known condition; those that `shift` generated (E), which knows of no conditions, and those of
/// each method that says for which condition its windows are; the real ones (D). Of several tested
/// conditions the one is shown whose speed is farthest from the known ones.
///
/// Each window is shown as a classifier gets it: without its mean, and with an RMS of 1, so that
/// recordings of different scales can be compared. Columns: panel,what,x,y, and one for each set:
/// known (known-2 and so on for more), the methods, and real. What x, y and the values are depends
/// on the panel:
///   row          the speed of the shaft in the set that `what` names, in rpm, and its condition;
///                y is empty where the method knows of none, and x then the tested speed
///   waveform, spectrum, envelope
///                as in windows_by_class.hpp, to an RMS of 1
///   line         y is the number of the harmonic of the class's own fault line, which `what`
///                names; for each set where it lies at the speed of that set, in Hz, without slip.
///                Empty beyond the end of the envelope's axis; up to the twelfth
/// Throws LeftOut where the data set does not tell known conditions from tested ones.
std::vector<Picture> other_condition(Source& source);

}  // namespace piae::figures
