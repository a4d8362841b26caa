#include "report/paper_reference.hpp"

namespace piae::report {

std::string PaperReference::none() const {
  if (!counterpart_ || counterpart_->own) return "";
  return " (" + dataset_ + " " + counterpart_->relation + ")";
}

std::string PaperReference::table(int PaperDataset::*number) const {
  return counterpart_ ? brackets("Table " + std::to_string(counterpart_->paper.*number)) : "";
}

std::string PaperReference::figure(int PaperDataset::*number) const {
  return counterpart_ ? figure(counterpart_->paper.*number) : "";
}

std::string PaperReference::figure(int number) const {
  return counterpart_ ? brackets("Fig. " + std::to_string(number)) : "";
}

std::string PaperReference::label() const {
  if (!counterpart_ || counterpart_->own) return "paper";
  return std::string("paper, ") + counterpart_->paper.title;
}

std::string PaperReference::brackets(const std::string& what) const {
  if (counterpart_->own) return " (the paper's " + what + ")";
  return " (in the place of the paper's " + what + "; " + dataset_ + " " + counterpart_->relation +
         ")";
}

}  // namespace piae::report
