#include "figures/line_name.hpp"

namespace piae::figures {

std::string line_name(signal::Defect defect) {
  return defect == signal::Defect::outer   ? "BPFO"
         : defect == signal::Defect::inner ? "BPFI"
                                           : "2BSF";
}

}  // namespace piae::figures
