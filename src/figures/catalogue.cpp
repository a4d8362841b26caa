#include "figures/catalogue.hpp"

#include "figures/curves.hpp"
#include "figures/feature_maps.hpp"
#include "figures/gains.hpp"
#include "figures/quality.hpp"
#include "figures/twin_space.hpp"
#include "figures/windows_by_class.hpp"

namespace piae::figures {

namespace {

constexpr Figure figures[] = {
    {.name = "fig15-gains",
     .paper = "Fig. 15",
     .title = "What generated windows gain, by ratio",
     .caption =
         "Accuracy minus that of the same seed without generated windows, in points. Dots are "
         "seeds, lines their mean, bars its 95 % interval; the dashed line is what the paper "
         "publishes. The ceiling learns from real windows instead of generated ones. Below zero a "
         "method does harm.",
     .from = "seed*/<method>/<ratio>/diagnosis.h5, /predictions",
     .numbers = gains_of_methods},
    {.name = "fig18-gains-of-models",
     .paper = "Fig. 18",
     .title = "What the windows of the paper's five models gain, by ratio",
     .caption = "As Fig. 15, of PIAE-DT (Model 1) and of what is left when one part of it is taken "
                "away or exchanged.",
     .from = "seed*/<method>/<ratio>/diagnosis.h5, /predictions",
     .numbers = gains_of_models},
    {.name = "accuracies",
     .paper = "",
     .title = "Accuracy by ratio",
     .caption = "Mean accuracy in percent over the seeds with its 95 % interval; dots are seeds. "
                "The grey band is the accuracy without generated windows.",
     .from = "seed*/<method>/<ratio>/diagnosis.h5, /predictions",
     .numbers = accuracies},
    {.name = "fig13-14-quality",
     .paper = "Figs 13 and 14",
     .title = "How good the generated windows are",
     .caption =
         "MMD and RMSE as in the paper, where small is good, and beside them what does not reward "
         "silence: an amplitude ratio of 1 and differences of 0 dB are those of real windows. A "
         "window of zeros has a small RMSE.",
     .from = "seed*/<method>/score.h5, /quality",
     .numbers = quality_of_methods},
    {.name = "fig16-17-quality-of-models",
     .paper = "Figs 16 and 17",
     .title = "How good the windows of the paper's five models are",
     .caption = "As Figs 13 and 14, of PIAE-DT (Model 1) and its ablations.",
     .from = "seed*/<method>/score.h5, /quality",
     .numbers = quality_of_models},
    {.name = "fig09-10-twin-space",
     .paper = "Figs 9 and 10",
     .title = "The digital twin space",
     .caption =
         "Joint histogram of stiffness and damping over the known windows, from which new ones are "
         "drawn; its marginals above and beside it. Rings are known windows, dots generated ones, "
         "crosses the true values where windows are simulated.",
     .from = "seed<first>/<method>/model.h5, /twin_space; E.h5, /parameters",
     .numbers = twin_space},
    {.name = "fig11-12-windows",
     .paper = "Figs 11 and 12",
     .title = "Real and generated windows",
     .caption =
         "One picture for each fault class, with all rows on the same axes. The window shown, of D "
         "where it is real and of E where a method made it, is the one whose RMS is the median of "
         "its set. Both spectra are means of all windows of the class, in dB to 1 m/s^2; those of "
         "real windows stand in grey behind each. Lines are where a defect of the outer race "
         "(BPFO), the inner race (BPFI) or a rolling element (2 BSF) shows in the envelope, and "
         "its harmonics, at the nominal speed without slip; dotted ones lie a turn of the shaft "
         "beside those of this class.",
     .from = "seed<first>/D.h5 and seed<first>/<method>/E.h5, /windows",
     .pictures = windows_by_class},
    {.name = "fig20-tsne-hidden",
     .paper = "Fig. 20",
     .title = "Test windows as the classifier's hidden layer sees them",
     .caption =
         "t-SNE of all test windows by the 100 features of the last hidden layer; each method at "
         "its ratio with the most generated windows. What lies together is alike to the "
         "classifier; "
         "how wide groups are and how far apart says little. Trustworthiness is 1 where all "
         "neighbours on the map are neighbours in the layer, and about 0.5 by chance; KL is what "
         "the map loses, in nats.",
     .from = "seed<first>/<method>/<ratio>/features.h5, /features/hidden",
     .numbers = hidden_map},
    {.name = "fig21-tsne-output",
     .paper = "Fig. 21",
     .title = "Test windows as the classifier's output layer sees them",
     .caption = "As Fig. 20, by the features of the output layer, before the softmax: one for each "
                "class.",
     .from = "seed<first>/<method>/<ratio>/features.h5, /features/output",
     .numbers = output_map},
    {.name = "fig07-losses",
     .paper = "Fig. 7",
     .title = "Losses of PIAE-DT by epoch",
     .caption =
         "Faint lines are seeds, strong ones their mean. In Stage 1 each network follows its "
         "own loss, in Stage 2 all follow the total one.",
     .from = "seed*/piae-dt/model.h5, /curves",
     .numbers = loss_curves},
    {.name = "fig08-loss-weights",
     .paper = "Fig. 8",
     .title = "Weights of the losses by epoch",
     .caption = "The weights of eq. 23 for reconstruction (alpha), the differential data loss "
                "(beta) and the twin's residual (gamma); faint lines are seeds.",
     .from = "seed*/piae-dt/model.h5, /curves",
     .numbers = weight_curves},
};

}  // namespace

std::span<const Figure> catalogue() { return figures; }

}  // namespace piae::figures
