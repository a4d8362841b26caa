#pragma once

#include <vector>

#include "figures/picture.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns windows of faults that are known in one condition and tested in another, for the first
/// seed; a picture for each fault class. The sets of windows are, in this order: the known ones (C)
/// of each known condition; those that `shift` generated (E), which ignores conditions, and those
/// of each method whose windows have a condition; the real ones (D). Among several tested
/// conditions, the one with the speed farthest from the known one is shown.
///
/// Windows are shown as a classifier gets them: without mean and with an RMS of 1, so that
/// recordings of different scales can be compared. Columns: panel,what,x,y, and one for each set:
/// known (known-2 and so on for more), the methods, and real. The meaning of x, y and the values
/// depends on the panel:
///   row          the shaft speed of the set that `what` names, in rpm, and its condition;
///                y is empty if the method ignores conditions, and x then the tested speed
///   waveform, spectrum, envelope
///                as in windows_by_class.hpp, to an RMS of 1
///   line         y is the harmonic number of the class's own fault line, which `what` names;
///                the values are its frequency at the speed of each set, in Hz, without slip;
///                empty beyond the end of the envelope's axis; up to the twelfth
/// Throws LeftOut if the data set does not separate known conditions from tested ones.
std::vector<Picture> other_condition(Source& source);

}  // namespace piae::figures
