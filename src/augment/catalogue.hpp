#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "augment/method.hpp"

namespace piae::augment {

/// What a method is to the experiment; tables and defaults go by it.
enum class Kind {
  baseline,   ///< `none`: the classifier without generated windows
  published,  ///< one of the methods that the paper compares (Section 4.5.3)
  ablation,   ///< the paper's method with one part left out or exchanged (Section 4.5.4)
  ours,       ///< a method of this project
  control,    ///< knows nothing of bearings: what a method must beat to be worth anything
  ceiling,    ///< no method: it sees real windows that no method may see
};

/// One entry of METHODS.
struct CatalogueEntry {
  const char* name;  ///< in METHODS, of folders and in tables
  Kind kind;
  const char* what;                             ///< in a few words
  std::unique_ptr<Method> (*make)() = nullptr;  ///< null for the baseline, which makes nothing
  int model = 0;        ///< number of the paper's model (Tables 10 and 11), 0 for none of them
  bool infers = false;  ///< stiffness and damping of windows that it has not seen
};

/// All there are, in the order of the tables. This is the one place that knows the methods:
/// programs look here, and make asks a program.
std::span<const CatalogueEntry> catalogue();

/// Null for a name that is not in the catalogue.
const CatalogueEntry* find_entry(const std::string& name);

/// The name of the baseline, which has the ratio 100to1 to itself.
inline const std::string no_method = "none";

/// Whether that is a ceiling. It has no score, which would compare D with itself.
bool is_ceiling(const std::string& name);

/// Names of all that generate windows.
std::vector<std::string> method_names();

/// Throws Error(usage) that lists the known ones.
std::unique_ptr<Method> make_method(const std::string& name);

/// Whether LibTorch alone computes its networks, also where no back end is asked for.
bool needs_libtorch_always(const CatalogueEntry& entry);

}  // namespace piae::augment
