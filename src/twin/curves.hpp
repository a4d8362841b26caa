#pragma once

#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"

namespace piae::twin {

/// The curves of the paper's Figs 7 and 8, one value per epoch: the mean of each loss over the
/// epoch's batches, and the weights of eq. 23 and the learning rate at its end. Without the physics
/// module L_DDL and L_DT are 0, L_total is L_Rec, and the weights stay at 1.
struct Curves {
  std::vector<double> reconstruction;  ///< L_Rec
  std::vector<double> differential;    ///< L_DDL
  std::vector<double> twin;            ///< L_DT
  std::vector<double> total;           ///< L_total
  std::vector<double> alpha;
  std::vector<double> beta;
  std::vector<double> gamma;
  std::vector<double> learning_rate;

  /// Writes datasets /curves/<name>, [epochs].
  void write(artefact::Writer& writer) const;
  /// Throws artefact::Refusal if curves have different lengths or impossible values.
  void read(const artefact::Reader& reader);
};

}  // namespace piae::twin
