#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "augment/method.hpp"
#include "cli/options.hpp"

namespace piae::augment {

/// Settings of SMOTE and its variants.
struct SmoteOptions {
  /// k; Chawla et al. take 5, but with five known windows each has only 4 others.
  int neighbours = 4;
  /// m; as imbalanced-learn, 5 for `adasyn` and 10 for `borderline-smote`. `smote` has none.
  int foreign_among = 0;
};

/// Method `smote` (Chawla et al. 2002, "SMOTE: synthetic minority over-sampling technique") and two
/// variants. A generated window lies on the line from a known window, the starting point, to one of
/// its k nearest known windows of the same class, at a uniformly drawn place. As in Chawla et al.,
/// each known window is the starting point equally often. All samples of a window use one gap, as
/// in their text (a point on the line); their listing draws one gap for each sample.
///
/// The variants choose starting points by the m real windows, known or healthy, nearest to a known
/// window, and count those of other classes. As in imbalanced-learn, every other class is foreign.
/// `adasyn` (He et al. 2008, "ADASYN: adaptive synthetic sampling approach for imbalanced
/// learning") makes windows in proportion to this number. `borderline-smote` (Han et al. 2005,
/// "Borderline-SMOTE", the variant borderline-1) starts only from windows in danger, which have at
/// least m / 2 foreign neighbours, but not m. Both make the windows of `smote` for a class without
/// such a starting point.
///
/// The model holds the known windows and, for the variants, their foreign neighbours. Throws
/// Error(usage) for k above n - 1, and for m above the number of other real windows.
class Smote final : public Method {
 public:
  /// Known windows that are starting points.
  enum class Start {
    every,          ///< `smote`
    foreign_share,  ///< `adasyn`
    in_danger,      ///< `borderline-smote`
  };

  explicit Smote(Start start);

  void use_healthy(const signal::WindowSet& healthy) override;
  void bind(const cli::Options& command) override;
  void train(const signal::WindowSet& known, const Stream& stream, const Compute& compute,
             const nets::Checkpoint& checkpoint, artefact::Writer& model) override;
  [[nodiscard]] std::string remark() const override { return remark_; }
  signal::WindowSet generate(const artefact::Reader& model, std::size_t count, const Stream& stream,
                             const Compute& compute) override;

 private:
  /// Weights of the known windows as starting points.
  struct Weights {
    std::vector<std::int64_t> of_windows;
    std::int64_t classes_as_smote = 0;  ///< fault classes without a starting point of their own
  };

  [[nodiscard]] Weights weights_from(const std::vector<std::int64_t>& foreign, int among,
                                     const signal::WindowSet& known) const;
  [[nodiscard]] std::vector<std::int64_t> read_weights(const artefact::Reader& model,
                                                       const signal::WindowSet& known) const;

  Start start_;
  SmoteOptions options_;
  std::optional<signal::WindowSet> healthy_;
  std::string remark_;
};

}  // namespace piae::augment
