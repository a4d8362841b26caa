#pragma once

#include <string>

#include "report/document.hpp"
#include "report/transfer.hpp"

namespace piae::report {

/// transfer@GROUP.csv, of which the picture is drawn too:
/// dataset,speed_ratio,method,role,classifier,recorded,best,ratio,seed,accuracy,std,ci95_low,
/// ci95_high,kind,kind_std,kind_ci95_low,kind_ci95_high,kind_recorded,kind_best
/// in percent. `dataset` is "mean" for the mean over the group, `seed` "mean" for that over the
/// seeds, which alone has a deviation and an interval. `speed_ratio` is the tested speed divided by
/// the known one. `role` is "against" for the method that the others are subtracted from,
/// "ceiling", "bar" for none by nearest, and else "method". `recorded` is 1 for the input that was
/// chosen before, `best` 1 for the best of a trained classifier in this run. Of kinds of defects
/// only where they are told apart; their inputs have marks of their own.
std::string transfer_csv(const TransferGroup& group);

/// transfer-comparisons@GROUP.csv: group,ratio,method,classifier,minus,minus_classifier and
/// paired_columns(). The difference is the accuracy of `method` minus that of `minus`.
std::string transfer_comparisons_csv(const TransferGroup& group);

/// The same for people.
Document transfer_document(const TransferGroup& group);

}  // namespace piae::report
