#include "figures/catalogue.hpp"

#include "figures/confusion.hpp"
#include "figures/cost.hpp"
#include "figures/critical_difference.hpp"
#include "figures/curves.hpp"
#include "figures/feature_maps.hpp"
#include "figures/gains.hpp"
#include "figures/identifiability.hpp"
#include "figures/missed_faults.hpp"
#include "figures/other_condition.hpp"
#include "figures/paired_differences.hpp"
#include "figures/protocols.hpp"
#include "figures/quality.hpp"
#include "figures/refusal.hpp"
#include "figures/reliability.hpp"
#include "figures/sweep.hpp"
#include "figures/twin_space.hpp"
#include "figures/windows_by_class.hpp"
#include "figures/worth_of_parts.hpp"

namespace piae::figures {

namespace {

constexpr Figure figures[] = {
    {.name = "fig15-gains",
     .paper = "Fig. 15",
     .title = "Gain of generated windows, by ratio",
     .caption =
         "Accuracy minus that of the same seed without generated windows, in points. Dots are "
         "seeds, marks their mean, bars its 95 % interval; dashed lines are the paper's values for "
         "the data set named in the key. The ceiling learns from real windows instead of generated "
         "ones. A negative gain does harm.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = gains_of_methods},
    {.name = "fig18-gains-of-models",
     .paper = "Fig. 18",
     .title = "Gain of windows from the paper's models and those of its outlook, by ratio",
     .caption = "As Fig. 15, for PIAE-DT (Model 1) and its ablations, in which one part is removed "
                "or exchanged, including those of the paper's outlook if the run has them.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = gains_of_models},
    {.name = "accuracies",
     .paper = "",
     .title = "Accuracy by ratio",
     .caption = "Mean accuracy in percent over the seeds with its 95 % interval; dots are seeds. "
                "The dotted line is the accuracy without generated windows, the dash-dotted one "
                "that of the nearest neighbour without them; dashed lines are the paper's values "
                "for the data set named in the key.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = accuracies},
    {.name = "cost",
     .paper = "",
     .title = "Accuracy by the cost of the generator",
     .caption =
         "With the most generated windows: accuracy, with its 95 % interval over the seeds, "
         "by the processor time of training a generator for one seed and generating its "
         "windows, as measured in an earlier run (jobs/costs.csv). The line joins methods "
         "to which no other is preferable: none is at least as accurate in less time. Methods "
         "whose cost was not measured are left out.",
     .from = "seed*/<method>/<last ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = costs_of_accuracy},
    {.name = "paired-differences",
     .paper = "",
     .title = "Each method against the method of interest, paired by seed",
     .caption = "Accuracy minus that of the same seed by piae-dt-phase, or else piae-dt (by "
                "strike-twin if faults are known in other conditions than tested), in points; left "
                "of zero a method is worse. Dots are seeds, marks their mean, bars its 95 % "
                "interval. "
                "p: Wilcoxon's test with Holm's correction over the methods of a panel.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = paired_differences},
    {.name = "critical-difference",
     .paper = "",
     .title = "Ranks of the methods",
     .caption = "Critical-difference diagram (Demsar 2006): average rank of each method among "
                "those of the same seed; 1 is the best. A bar joins methods that differ by less "
                "than the critical difference (CD): the test does not separate them at 0.05.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = critical_differences},
    {.name = "confusion",
     .paper = "",
     .title = "Confusion of the classes",
     .caption =
         "Confusion matrices over the test windows of all seeds, with the most generated windows: "
         "a "
         "row for each true class, in percent of its windows. Blue is correct, orange wrong; "
         "shares "
         "below 5 % have no number.",
     .from = "seed*/<method>/<last ratio>/wdcnn/diagnosis.h5, /labels and /predictions",
     .numbers = confusions},
    {.name = "missed-faults",
     .paper = "",
     .title = "Missed faults and false alarms",
     .caption = "Test windows of each fault that were classified as healthy, and healthy ones that "
                "were classified as a fault, in percent, with the most generated windows. Dots are "
                "seeds, marks their "
                "mean; further left is better.",
     .from = "seed*/<method>/<last ratio>/wdcnn/diagnosis.h5, /labels and /predictions",
     .numbers = missed_faults},
    {.name = "reliability",
     .paper = "",
     .title = "Calibration of the classifier",
     .caption = "Test windows of all seeds, with the most generated windows, in ten bins by the "
                "score of the predicted class. Below the diagonal the classifier is overconfident. "
                "Grey bars are the share of the windows in each bin; ECE is the mean distance "
                "from the diagonal, weighted by them.",
     .from = "seed*/<method>/<last ratio>/<classifier>/diagnosis.h5, /scores and /predictions",
     .accuracies = reliabilities},
    {.name = "refusal",
     .paper = "",
     .title = "Effect of refusing the least certain windows",
     .caption = "Percent of correct answers if only part of the test windows is answered: those "
                "with the highest score of the predicted class. Mean over the seeds, with the most "
                "generated windows; at the right edge, where all are answered, it is the accuracy. "
                "A horizontal line means that the scores do not separate correct from wrong "
                "answers. The dashed line is the precision of confidence.csv. Shares come from the "
                "test windows themselves: a user must choose the threshold beforehand.",
     .from = "seed*/<method>/<last ratio>/<classifier>/diagnosis.h5, /scores and /predictions",
     .accuracies = refusals},
    {.name = "protocols",
     .paper = "",
     .title = "Effect of overlapping windows",
     .caption = "Accuracy in percent with the paper's split, in which test windows overlap "
                "training windows, and with a split without overlap. Dots are seeds, marks their "
                "mean, "
                "bars its 95 % interval.",
     .from = "seed*/<method>/<ratio>/wdcnn/diagnosis.h5, /predictions, of the run and of "
             "RUN-blocked",
     .numbers = protocols},
    {.name = "fig19-sweep",
     .paper = "Fig. 19",
     .title = "The settings of PIAE-DT, one at a time",
     .caption = "Accuracy in percent with one setting moved and all others unchanged. Dots are "
                "seeds, marks "
                "their mean, bars its 95 % interval; the shaded value is the one of the grid.",
     .from = "seed*/sweep/<setting>/<ratio>/wdcnn/diagnosis.h5, "
             "seed*/piae-dt/<ratio>/wdcnn/diagnosis.h5",
     .numbers = sweeps},
    {.name = "worth-of-parts",
     .paper = "",
     .title = "Effect of each part of a method",
     .caption = "Accuracy with one setting moved and all others unchanged, minus that of the same "
                "seed by the unchanged method, in points: left of zero the method is worse without "
                "that part. Dots "
                "are seeds, marks their mean, bars its 95 % interval. An arrow goes from the "
                "method's own value to the moved one.",
     .from =
         "sweep@<method>.csv, which `sweep` makes of seed*/sweep@<method>/<setting>/<ratio>/ and "
         "seed*/<method>/<ratio>/; seed<first>/<method>/model.h5",
     .pictures = worth_of_parts},
    {.name = "identifiability",
     .paper = "",
     .title = "Stiffness and damping, inferred against true",
     .caption = "Windows that the models have not seen, in ten groups by their true value: the "
                "median of the inferred values, and the range of 80 % of them. On the diagonal "
                "both are equal. R2 is 1 there, and 0 if the mean would be as good an estimate.",
     .from = "scatter.csv and identifiability.csv, which `identify` makes of seed*/D.h5 and "
             "seed*/<method>/model.h5",
     .numbers = identifiability},
    {.name = "fig13-14-quality",
     .paper = "Figs 13 and 14",
     .title = "Quality of the generated windows",
     .caption = "MMD (here its square) and RMSE as in the paper, for which small is good, and "
                "measures that do not reward silence: real windows have an amplitude ratio of 1 "
                "and differences of 0 dB. A window of zeros has a small RMSE.",
     .from = "seed*/<method>/score.h5, /quality",
     .numbers = quality_of_methods},
    {.name = "fig16-17-quality-of-models",
     .paper = "Figs 16 and 17",
     .title = "Quality of windows from the paper's models and those of its outlook",
     .caption = "As Figs 13 and 14, for PIAE-DT (Model 1) and its ablations, including those of "
                "the paper's outlook if the run has them.",
     .from = "seed*/<method>/score.h5, /quality",
     .numbers = quality_of_models},
    {.name = "fig09-10-twin-space",
     .paper = "Figs 9 and 10",
     .title = "The digital twin space",
     .caption =
         "Joint histogram of stiffness and damping over the known windows, from which new ones are "
         "drawn (piae-dt-phase draws from one for each class), with its marginals. Rings are known "
         "windows, dots generated ones, crosses the true values if windows are simulated.",
     .from = "seed<first>/<method>/model.h5, /twin_space; E.h5, /parameters",
     .numbers = twin_space},
    {.name = "fig11-12-windows",
     .paper = "Figs 11 and 12",
     .title = "Real and generated windows",
     .caption =
         "One picture for each fault class, with all rows on the same axes. The window shown (of D "
         "if real, of E if generated) is the one with the median RMS of its set. Both spectra are "
         "means of all windows of the class, in dB re 1 m/s^2 (re the unit of the recordings if it "
         "is unknown); those of real windows are grey behind each. Lines mark the frequencies of a "
         "defect of the outer race (BPFO), the inner race (BPFI) or a rolling element (2 BSF) in "
         "the envelope, with harmonics, at the nominal speed without slip; dotted ones are "
         "sidebands of this class at the shaft frequency.",
     .from = "seed<first>/D.h5 and seed<first>/<method>/E.h5, /windows",
     .pictures = windows_by_class},
    {.name = "other-condition",
     .paper = "",
     .title = "Faults known in one condition and tested in another",
     .caption =
         "One picture for each fault class. Above, the known windows (C) at their own speed; "
         "below, at the tested speed, the windows that methods generate from them (E) and the real "
         "windows (D), whose spectra are grey behind all others. Shift ignores conditions. Each "
         "window is shown as a classifier receives it, without its mean and divided by its own "
         "RMS, because recordings may differ in scale; levels are in dB re that RMS. The window "
         "shown is the one with the median RMS of its set; both spectra are means of all windows. "
         "Lines in the envelope mark the class's own defect (BPFO, BPFI or 2 BSF and harmonics) at "
         "the speed of the row, without slip: they move with the shaft speed, while resonances, in "
         "the amplitude spectrum, do not. A bar in the waveform is as long as one period of the "
         "defect. If several conditions are tested, the one with the speed farthest from the known "
         "ones is shown.",
     .from = "seed<first>/C.h5, seed<first>/D.h5 and seed<first>/<method>/E.h5, /windows",
     .pictures = other_condition},
    {.name = "fig20-tsne-hidden",
     .paper = "Fig. 20",
     .title = "Test windows as the classifier's hidden layer sees them",
     .caption =
         "t-SNE of all test windows by the 100 features of the last hidden layer; each method at "
         "its ratio with the most generated windows. Neighbouring points are similar to the "
         "classifier; the size of groups and their distances mean little. Trustworthiness is 1 if "
         "all neighbours on the map are neighbours in the layer, and about 0.5 by chance; KL is "
         "the loss of the map, in nats.",
     .from = "seed<first>/<method>/<ratio>/wdcnn/features.h5, /features/hidden",
     .numbers = hidden_map},
    {.name = "fig21-tsne-output",
     .paper = "Fig. 21",
     .title = "Test windows as the classifier's output layer sees them",
     .caption = "As Fig. 20, by the features of the output layer, before the softmax: one for each "
                "class.",
     .from = "seed<first>/<method>/<ratio>/wdcnn/features.h5, /features/output",
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
     .caption =
         "The weights of eq. 23 for the dimensionless differential loss (alpha), the digital "
         "twin loss (beta) and the reconstruction loss (gamma); faint lines are seeds. Dotted: "
         "1 / (2 L), where eq. 23 is minimal for the loss L of the epoch.",
     .from = "seed*/piae-dt/model.h5, /curves",
     .numbers = weight_curves},
};

}  // namespace

std::span<const Figure> catalogue() { return figures; }

}  // namespace piae::figures
