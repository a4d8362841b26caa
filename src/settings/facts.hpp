#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::settings {

/// What make has to know of the experiment, each as one word "kind:value", so that it is written
/// down in one place only:
///
///     method:smote           an entry of METHODS, in the order of the tables
///     paper:smote            one of the paper's: what the word `paper` among METHODS stands for
///     default:shift          one of the METHODS where none are given: the paper's, and what we
///                            recommend
///     paper-method:piae-dt   the paper's own method
///     baseline:none          the method that generates nothing
///     ceiling:oracle         sees real windows that no method may see, and has no score
///     needs-size:piae-dt     has to be told defect_size_mm of each fault; needs-rhythm: that it is
///                            one of the bearing; needs-bearing: the bearing's geometry
///     infers:piae-dt         infers (k, c) of windows that it has not seen
///     classifier:nearest     an entry of CLASSIFIERS, in the order of the tables
///     paper-classifier:wdcnn the paper's: the CLASSIFIERS where none are given
///     bar:nearest            what is always computed of the baseline, for comparison
///     ratio:10to1            an entry of RATIOS
///     nothing-generated:100to1
///     dataset:cwru           an entry of DATASETS
///     simulated:simulated    a dataset that is made, not measured
///     own-split:NAME         a dataset whose description says something of the stage split
///     without-size:NAME      a dataset whose description does not say that of all faults; so
///                            without-rhythm and without-bearing
///     nothing-known:NAME     a dataset of which no fault window is known
///     pair:vae/nearest       a method that has cells by this classifier
///     pair-of-nothing:oracle/nearest   the same of a data set of which no fault window is known
///     swept:piae-dt          a method whose settings `make sweep` moves
///     sweep-classifier:piae-dt:wdcnn   by which it is judged then
///     sweep-point:piae-dt:batch=1      a setting that is tried
///     sweep-centre:piae-dt:batch=5     one of those that the method has anyway
///     group:speeds           a group of data sets that `make transfer` averages over
///     group-dataset:speeds/NAME  a data set of it, which need not be there
///     group-method:speeds/none   a method of which an input is recorded
///     group-input:speeds/none=wdcnn-spectra  each input of it, for whichever question
///
/// `pipeline` is the folder with protocol.toml and datasets/. Throws as read_protocol does.
std::vector<std::string> facts(const std::filesystem::path& pipeline);

}  // namespace piae::settings
