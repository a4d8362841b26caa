#pragma once

#include <vector>

#include "figures/picture.hpp"
#include "figures/source.hpp"

namespace piae::figures {

/// Returns Figs 11 and 12: real windows (D) and those that each method of the grid generated (E),
/// for the first seed; a picture for each fault class. Columns: panel,what,x,y,real, and one for
/// each method. The meaning of x, y and the values depends on the panel:
///   waveform     ms; values of the shown window in m/s^2, where `what` is the lowest or the
///                highest of some samples
///   unit         unit of the values: `what` is m/s2, or recordings if that is not known (a
///                unit of 1 may be m/s^2, or have been left out)
///   spectrum     Hz; mean amplitude of all windows in dB, to 1 m/s^2
///   envelope     Hz; the same of their envelopes
///   spectrogram  ms and Hz; amplitude of the shown window in dB, to 1 m/s^2
///   own-line, line, sideband
///                Hz and harmonic number of a fault line, which `what` names, at the nominal
///                speed; of the class's own defect, of others, and one shaft frequency from
///                the own one
std::vector<Picture> windows_by_class(Source& source);

}  // namespace piae::figures
