#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "augment/method.hpp"

namespace piae::augment {

/// What a method is to the experiment. Tables and defaults go by it.
enum class Kind {
  baseline,   ///< `none`: the classifier without generated windows
  published,  ///< one of the methods that the paper compares (Section 4.5.3)
  ablation,   ///< the paper's method with one part left out or exchanged (Section 4.5.4)
  outlook,    ///< an ablation that the paper does not make, but names for the future (Section 5)
  ours,       ///< a method of this project
  control,    ///< knows nothing of bearings: what a method must beat to be worth anything
  ceiling,    ///< not a method: it sees real windows that no method may see
};

/// What a method has to be told of each fault, beside its windows.
enum class Needs {
  nothing,
  bearing,  ///< the geometry of the bearing
  rhythm,   ///< that, and a defect in it: not `other`
  size,     ///< that, and its defect_size_mm
};

/// One entry of the catalogue of methods.
struct CatalogueEntry {
  const char* name;  ///< the name in METHODS, in folders and in tables
  Kind kind;
  const char* what;                             ///< what it does, in a few words
  std::unique_ptr<Method> (*make)() = nullptr;  ///< null for the baseline, which generates nothing
  int model = 0;         ///< number of the model in the paper (Tables 10 and 11); 0 for no model
  bool infers = false;   ///< whether it infers stiffness and damping of windows it has not seen
  bool hears = false;    ///< whether it takes healthy windows B beside the known ones
  bool carries = false;  ///< whether it is made for faults that are known in other conditions alone
  bool trains = false;   ///< whether it is trained or fitted in epochs, by nets::run_epochs()
  bool without_known = false;  ///< whether it makes faults of which no window is known
  Needs needs = Needs::nothing;
  bool recommended = false;  ///< whether a run has it beside the paper's where nobody chooses
};

/// All entries in the order of the tables. This is the one place that knows the methods: programs
/// look here, and make asks a program.
std::span<const CatalogueEntry> catalogue();

/// The entry of that name; null when there is none.
const CatalogueEntry* find_entry(const std::string& name);

/// The name of the baseline, which is the only entry that runs at the ratio 100to1.
inline const std::string no_method = "none";

/// The name of the paper's own method, which is its Model 1; the other models are ablations of it.
const std::string& paper_method();

/// Whether a method is the paper's with one part left out or exchanged, in the paper or in its
/// outlook.
bool is_ablation(const CatalogueEntry& entry);

/// Whether this is the name of a ceiling. A ceiling has no score, which would compare D with
/// itself.
bool is_ceiling(const std::string& name);

/// Whether a method makes windows where no fault window is known: one that is made for that, or a
/// ceiling, which learns from others.
bool works_without_known(const CatalogueEntry& entry);

/// The names of all entries that generate windows; and of those that do where no fault window is
/// known.
std::vector<std::string> method_names();
std::vector<std::string> methods_without_known();

/// Throws Error(bad_input), which lists the methods that would work, where C (`file`) holds no
/// window and this method learns from those.
void require_known_windows(const CatalogueEntry& entry, const signal::WindowSet& known,
                           const std::string& file);

/// Throws Error(bad_input), which lists the methods that would work, where the description does not
/// say of each fault what this method needs. `file` is the one that the info is from.
void require_described_faults(const CatalogueEntry& entry, const signal::DatasetInfo& info,
                              const std::string& file);

/// "12 windows of 3 fault classes", or "no fault window".
std::string counted_faults(const signal::WindowSet& known);

/// Makes the method of that name. Throws Error(usage), which lists the known names, for any other.
std::unique_ptr<Method> make_method(const std::string& name);

}  // namespace piae::augment
