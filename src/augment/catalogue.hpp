#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "augment/method.hpp"

namespace piae::augment {

/// Role of a method in the experiment. Tables and defaults depend on it.
enum class Kind {
  baseline,   ///< `none`: the classifier without generated windows
  published,  ///< one of the methods that the paper compares (Section 4.5.3)
  ablation,   ///< the paper's method with one part left out or exchanged (Section 4.5.4)
  outlook,    ///< an ablation that the paper does not test, but names as future work (Section 5)
  ours,       ///< a method of this project
  control,  ///< knows nothing of bearings; a method that does not beat it has no effect of its own
  ceiling,  ///< not a method: it uses real windows that no method may use
};

/// Facts that a method needs about each fault, in addition to its windows.
enum class Needs {
  nothing,
  bearing,      ///< the geometry of the bearing
  impact_rate,  ///< the geometry, and a defect type other than `other`
  size,         ///< the same as `impact_rate`, and defect_size_mm
};

/// Use that a method makes of healthy windows B, in addition to the known ones.
enum class Healthy { unused, optional, required };

/// One entry of the catalogue of methods.
struct CatalogueEntry {
  const char* name;  ///< the name in METHODS, in folders and in tables
  Kind kind;
  const char* what;                             ///< short description
  std::unique_ptr<Method> (*make)() = nullptr;  ///< null for the baseline, which generates nothing
  int model = 0;        ///< number of the model in the paper (Tables 10 and 11); 0 for no model
  bool infers = false;  ///< true if it infers stiffness and damping of windows that it has not seen
  Healthy healthy = Healthy::unused;
  bool carries = false;  ///< true if it is made for faults that are known in other conditions only
  bool trains = false;   ///< true if nets::run_epochs() trains or fits it in epochs
  bool without_known = false;  ///< true if it makes faults of which no window is known
  Needs needs = Needs::nothing;
  bool recommended = false;  ///< true if a run includes it by default, next to the paper's method
};

/// Returns all entries in the order of the tables. This table is the only list of methods: programs
/// read it, and the Makefile asks a program.
std::span<const CatalogueEntry> catalogue();

/// Returns the entry of that name; null if there is none.
const CatalogueEntry* find_entry(const std::string& name);

/// Name of the baseline, the only entry that runs at the ratio 100to1.
inline const std::string no_method = "none";

/// Returns the name of the paper's method, its Model 1. The other models are ablations of Model 1.
const std::string& paper_method();

/// True for the paper's method with one part left out or exchanged, in the paper or in its outlook.
bool is_ablation(const CatalogueEntry& entry);

/// True if `name` is a ceiling. A ceiling has no score, because a score would compare D with
/// itself.
bool is_ceiling(const std::string& name);

/// True if a method makes windows although no fault window is known: it is made for this case, or
/// is a ceiling, which learns from other windows.
bool works_without_known(const CatalogueEntry& entry);

/// Return the names of all entries that generate windows, and of those that can without known fault
/// windows.
std::vector<std::string> method_names();
std::vector<std::string> methods_without_known();

/// Throws Error(bad_input), which lists the methods that would work, if C (`file`) holds no window
/// and this method learns from C.
void require_known_windows(const CatalogueEntry& entry, const signal::WindowSet& known,
                           const std::string& file);

/// Throws Error(bad_input), which lists the methods that would work, if the description lacks a
/// fact that this method needs about a fault. `file` is the file that holds `info`.
void require_described_faults(const CatalogueEntry& entry, const signal::DatasetInfo& info,
                              const std::string& file);

/// Returns "12 windows of 3 fault classes", or "no fault window".
std::string counted_faults(const signal::WindowSet& known);

/// Makes the method of that name. Throws Error(usage), which lists the known names, if there is
/// none.
std::unique_ptr<Method> make_method(const std::string& name);

}  // namespace piae::augment
