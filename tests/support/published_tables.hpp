#pragma once

#include "support/folder.hpp"

namespace piae {

/// Names of the paper's tables in the folder that report::Published reads.
inline constexpr const char* published_baseline = "table6-7-baseline.csv";
inline constexpr const char* published_methods = "table8-9-methods.csv";
inline constexpr const char* published_ablation = "table10-11-ablation.csv";

/// Writes a few of their numbers: for `none`, and for three methods at 2to1.
inline void write_published_tables(const Folder& folder) {
  folder.write(published_baseline,
               "dataset,run1,run2,run3,average\ncwru,61.8,62,61.7,61.8\nhfhp,61,62,63,62\n");
  folder.write(published_methods,
               "dataset,method,2to1\ncwru,vae,91.2\ncwru,piae-dt,93.7\nhfhp,vae,90.86\n");
  folder.write(published_ablation, "dataset,model,2to1\ncwru,model1,93.7\ncwru,model2,91.7\n");
}

}  // namespace piae
