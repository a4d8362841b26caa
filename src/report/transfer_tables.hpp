#pragma once

#include <string>

#include "report/document.hpp"
#include "report/transfer.hpp"

namespace piae::report {

/// Returns transfer@GROUP.csv, which also feeds the figure:
/// dataset,speed_ratio,method,role,classifier,recorded,best,ratio,seed,accuracy,std,ci95_low,
/// ci95_high,kind,kind_std,kind_ci95_low,kind_ci95_high,kind_recorded,kind_best in percent.
/// `dataset` is "mean" for the mean over the group. `seed` is "mean" for the mean over the seeds;
/// only these lines have a deviation and an interval. `speed_ratio` is the tested speed divided by
/// the known one. `role` is "against" for the method that the others are subtracted from,
/// "ceiling", "bar" for a reference (GroupChoices::shows()) that is not recorded, and otherwise
/// "method". `recorded` is 1 for the classifier chosen before, `best` is 1 for the best one in this
/// run. The columns kind*
/// are filled only for data sets with fault types.
std::string transfer_csv(const TransferGroup& group);

/// Returns transfer-comparisons@GROUP.csv: group,ratio,method,classifier,minus,minus_classifier and
/// paired_columns(). The difference is the accuracy of `method` minus that of `minus`.
std::string transfer_comparisons_csv(const TransferGroup& group);

/// Returns the same for people.
Document transfer_document(const TransferGroup& group);

}  // namespace piae::report
