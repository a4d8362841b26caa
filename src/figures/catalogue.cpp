#include "figures/catalogue.hpp"

#include "figures/confusion.hpp"
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
     .title = "What generated windows gain, by ratio",
     .caption =
         "Accuracy minus that of the same seed without generated windows, in points. Dots are "
         "seeds, marks their mean, bars its 95 % interval; dashed is what the paper publishes of "
         "the "
         "data set that the key names. The ceiling learns from real windows instead of generated "
         "ones. Below zero a "
         "method does harm.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = gains_of_methods},
    {.name = "fig18-gains-of-models",
     .paper = "Fig. 18",
     .title = "What the windows of the paper's models and those of its outlook gain, by ratio",
     .caption =
         "As Fig. 15, of PIAE-DT (Model 1) and of what is left when one part of it is taken "
         "away or exchanged; with those that the paper's outlook names, where a run has them.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = gains_of_models},
    {.name = "accuracies",
     .paper = "",
     .title = "Accuracy by ratio",
     .caption =
         "Mean accuracy in percent over the seeds with its 95 % interval; dots are seeds. "
         "The dotted line is the accuracy without generated windows, the dash-dotted one that of "
         "the nearest neighbour without them; dashed is what "
         "the paper publishes of the data set that the key names.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = accuracies},
    {.name = "paired-differences",
     .paper = "",
     .title = "Each method against the method of interest, paired by seed",
     .caption = "Accuracy minus that of the same seed by piae-dt-phase, or else piae-dt (where "
                "faults are known in other conditions than tested, by strike-twin), in points; "
                "left of zero a method is worse. Dots are seeds, marks their mean, bars its 95 % "
                "interval. "
                "p is of "
                "Wilcoxon's test with Holm's correction over the methods of a panel.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = paired_differences},
    {.name = "critical-difference",
     .paper = "",
     .title = "How the methods rank",
     .caption =
         "Critical-difference diagram (Demsar 2006): average rank of each method among those of "
         "the same seed, 1 being the best. A bar joins methods that differ by less than the "
         "critical difference (CD): the test does not tell them apart at 0.05.",
     .from = "seed*/<method>/<ratio>/<classifier>/diagnosis.h5, /predictions",
     .accuracies = critical_differences},
    {.name = "confusion",
     .paper = "",
     .title = "What was taken for what",
     .caption =
         "Confusion matrices over the test windows of all seeds, with the most generated windows: "
         "a "
         "row for each true class, in percent of its windows. Blue is right, orange wrong; shares "
         "below 5 % have no number.",
     .from = "seed*/<method>/<last ratio>/wdcnn/diagnosis.h5, /labels and /predictions",
     .numbers = confusions},
    {.name = "missed-faults",
     .paper = "",
     .title = "Missed faults and false alarms",
     .caption =
         "Test windows of each fault that were taken for healthy, and healthy ones that were taken "
         "for a fault, in percent, with the most generated windows. Dots are seeds, marks their "
         "mean; further left is better.",
     .from = "seed*/<method>/<last ratio>/wdcnn/diagnosis.h5, /labels and /predictions",
     .numbers = missed_faults},
    {.name = "reliability",
     .paper = "",
     .title = "Whether the classifier is right as often as it says",
     .caption =
         "Test windows of all seeds, with the most generated windows, in ten bins by the "
         "score of the class that was named. Below the diagonal the classifier is surer than it "
         "may be. Grey bars are the share of the windows in each bin; ECE is the mean distance "
         "from the diagonal, weighted by them.",
     .from = "seed*/<method>/<last ratio>/<classifier>/diagnosis.h5, /scores and /predictions",
     .accuracies = reliabilities},
    {.name = "refusal",
     .paper = "",
     .title = "What refusing the least sure windows is worth",
     .caption =
         "How many of a hundred answers are right where only part of the test windows is answered: "
         "those with the largest score of the class that was named. The mean over the seeds, with "
         "the most generated windows; at the right edge, where all are answered, it is the "
         "accuracy. A line that is level says that the scores do not tell right from wrong. The "
         "dashed line is the precision of confidence.csv. Shares are read off the test windows "
         "themselves: a user must choose the threshold before.",
     .from = "seed*/<method>/<last ratio>/<classifier>/diagnosis.h5, /scores and /predictions",
     .accuracies = refusals},
    {.name = "protocols",
     .paper = "",
     .title = "What overlapping windows are worth",
     .caption =
         "Accuracy in percent with the paper's split, in which windows for testing overlap those "
         "for training, beside that with a split without overlap. Dots are seeds, marks their "
         "mean, "
         "bars its 95 % interval.",
     .from = "seed*/<method>/<ratio>/wdcnn/diagnosis.h5, /predictions, of the run and of "
             "RUN-blocked",
     .numbers = protocols},
    {.name = "fig19-sweep",
     .paper = "Fig. 19",
     .title = "The settings of PIAE-DT, one at a time",
     .caption = "Accuracy in percent where one setting is moved and all others stay. Dots are "
                "seeds, marks "
                "their mean, bars its 95 % interval; the shaded value is that of the grid.",
     .from = "seed*/sweep/<setting>/<ratio>/wdcnn/diagnosis.h5, "
             "seed*/piae-dt/<ratio>/wdcnn/diagnosis.h5",
     .numbers = sweeps},
    {.name = "worth-of-parts",
     .paper = "",
     .title = "What each part of a method is worth",
     .caption =
         "Accuracy where one setting is moved and all others stay, minus that of the same seed by "
         "the method as it is, in points: left of zero the method is worse without that part. Dots "
         "are seeds, marks their mean, bars its 95 % interval. An arrow goes from what the method "
         "has to what it was given.",
     .from =
         "sweep@<method>.csv, which `sweep` makes of seed*/sweep@<method>/<setting>/<ratio>/ and "
         "seed*/<method>/<ratio>/; seed<first>/<method>/model.h5",
     .pictures = worth_of_parts},
    {.name = "identifiability",
     .paper = "",
     .title = "Stiffness and damping, inferred against true",
     .caption =
         "Windows that the models have not seen, in ten groups by their true value: the median of "
         "what was inferred, and between what 80 % of it lie. On the diagonal both are the same. "
         "R2 is 1 there, and 0 where naming the mean would do as well.",
     .from = "scatter.csv and identifiability.csv, which `identify` makes of seed*/D.h5 and "
             "seed*/<method>/model.h5",
     .numbers = identifiability},
    {.name = "fig13-14-quality",
     .paper = "Figs 13 and 14",
     .title = "How good the generated windows are",
     .caption =
         "MMD (here its square) and RMSE as in the paper, where small is good, and beside them "
         "what does not reward "
         "silence: an amplitude ratio of 1 and differences of 0 dB are those of real windows. A "
         "window of zeros has a small RMSE.",
     .from = "seed*/<method>/score.h5, /quality",
     .numbers = quality_of_methods},
    {.name = "fig16-17-quality-of-models",
     .paper = "Figs 16 and 17",
     .title = "How good the windows of the paper's models and those of its outlook are",
     .caption = "As Figs 13 and 14, of PIAE-DT (Model 1) and its ablations, those of the paper's "
                "outlook too where a run has them.",
     .from = "seed*/<method>/score.h5, /quality",
     .numbers = quality_of_models},
    {.name = "fig09-10-twin-space",
     .paper = "Figs 9 and 10",
     .title = "The digital twin space",
     .caption =
         "Joint histogram of stiffness and damping over the known windows, from which new ones are "
         "drawn (piae-dt-phase draws from one of each class); its marginals above and beside it. "
         "Rings are known windows, dots generated ones, "
         "crosses the true values where windows are simulated.",
     .from = "seed<first>/<method>/model.h5, /twin_space; E.h5, /parameters",
     .numbers = twin_space},
    {.name = "fig11-12-windows",
     .paper = "Figs 11 and 12",
     .title = "Real and generated windows",
     .caption =
         "One picture for each fault class, with all rows on the same axes. The window shown, of D "
         "where it is real and of E where a method made it, is the one whose RMS is the median of "
         "its set. Both spectra are means of all windows of the class, in dB to 1 m/s^2 (where the "
         "recordings do not tell their unit, to that); those of "
         "real windows stand in grey behind each. Lines are where a defect of the outer race "
         "(BPFO), the inner race (BPFI) or a rolling element (2 BSF) shows in the envelope, and "
         "its harmonics, at the nominal speed without slip; dotted ones lie a turn of the shaft "
         "beside those of this class.",
     .from = "seed<first>/D.h5 and seed<first>/<method>/E.h5, /windows",
     .pictures = windows_by_class},
    {.name = "other-condition",
     .paper = "",
     .title = "Faults that are known in one condition and tested in another",
     .caption =
         "One picture for each fault class. Above, the known windows (C) at their own speed; "
         "below, "
         "at the tested one, what methods made of them (E) and the real windows (D), whose spectra "
         "stand in grey behind all others. Shift knows of no condition. Each window is shown as a "
         "classifier gets it, without its mean and divided by its own RMS, since recordings may "
         "differ in scale; levels are in dB to that RMS. The window shown is the one whose RMS is "
         "the median of its set; both spectra are means of all windows. Lines in the envelope are "
         "where the class's own defect shows (BPFO, BPFI or 2 BSF and harmonics) at the speed of "
         "the row, without slip: they move with the shaft, and resonances, in the amplitude "
         "spectrum, stay. A bar in the waveform is as long as one period of the defect. Of several "
         "tested conditions "
         "the one is shown whose speed is farthest from the known ones.",
     .from = "seed<first>/C.h5, seed<first>/D.h5 and seed<first>/<method>/E.h5, /windows",
     .pictures = other_condition},
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
         "1 / (2 L), where eq. 23 is least for the loss L of the epoch.",
     .from = "seed*/piae-dt/model.h5, /curves",
     .numbers = weight_curves},
};

}  // namespace

std::span<const Figure> catalogue() { return figures; }

}  // namespace piae::figures
