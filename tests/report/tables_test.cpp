#include "report/tables.hpp"

#include <algorithm>
#include <sstream>

#include "report/accuracy_table.hpp"
#include "report/paper.hpp"
#include "report/quality_table.hpp"
#include "run/held.hpp"
#include "support/published_tables.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string csv_header =
    "dataset,method,classifier,ratio,generated_per_class,seeds,mean,std,ci95_low,ci95_high,"
    "published\n";

class Tables : public StoredRun {
 protected:
  explicit Tables(const std::string& dataset = "cwru") : StoredRun(dataset) {
    write_published_tables(folder_);
  }
  [[nodiscard]] Published published() const { return Published(folder_.path()); }
  [[nodiscard]] std::vector<AccuracyRow> rows(const run::Grid& grid) const {
    return accuracy_rows(grid, collect(layout_, grid), published());
  }
  [[nodiscard]] Document document(const run::Grid& grid) const {
    return tables(grid, collect(layout_, grid), rows(grid), published(),
                  compare_by_classifier(rows(grid), ""), rank_by_classifier(rows(grid)));
  }
  [[nodiscard]] std::string gains(const run::Grid& grid) const {
    return accuracy_csv(gain_rows(rows(grid)));
  }
};

/// The deviation of two values a, b is |a - b| / sqrt(2).
TEST_F(Tables, WriteTwoSeedsAsCsv) {
  add_all();
  EXPECT_EQ(accuracy_csv(rows(grid_)), csv_header +
                                           "cwru,none,wdcnn,100to1,0,2,62.5000,3.5355,,,61.8\n"
                                           "cwru,vae,wdcnn,10to1,45,2,75.0000,0.0000,,,\n"
                                           "cwru,vae,wdcnn,2to1,145,2,90.0000,7.0711,,,91.2\n");
  EXPECT_EQ(quality_csv(grid_, collect(layout_, grid_)),
            "dataset,method,class,metric,seeds,mean,std\n"
            "cwru,vae,IR,mmd,2,0.6,0.141421\n"
            "cwru,vae,IR,rmse,2,1.2,0.282843\n"
            "cwru,vae,IR,aligned_rmse,2,3,0\n"
            "cwru,vae,IR,amplitude_ratio,2,4,0\n"
            "cwru,vae,IR,spectral_distance_db,2,5,0\n"
            "cwru,vae,IR,fault_line_db,2,6,0\n"
            "cwru,vae,IR,fault_line_difference_db,2,7,0\n"
            "cwru,vae,OR,mmd,2,1e-07,0\n"
            "cwru,vae,OR,rmse,2,1,0\n"
            "cwru,vae,OR,aligned_rmse,2,1,0\n"
            "cwru,vae,OR,amplitude_ratio,2,1,0\n"
            "cwru,vae,OR,spectral_distance_db,2,1,0\n"
            "cwru,vae,OR,fault_line_db,2,1,0\n"
            "cwru,vae,OR,fault_line_difference_db,2,1,0\n");
}

/// Pairs by seed: 75 - 60 and 75 - 65; 85 - 60 and 95 - 65. Published: 91.2 - 61.8.
TEST_F(Tables, PairGainsBySeed) {
  add_all();
  EXPECT_EQ(gains(grid_), csv_header +
                              "cwru,vae,wdcnn,10to1,45,2,12.5000,3.5355,,,\n"
                              "cwru,vae,wdcnn,2to1,145,2,27.5000,3.5355,,,29.4\n");
  EXPECT_EQ(gains(grid("vae", "10to1")), csv_header) << "nothing to compare with";
  EXPECT_EQ(gains(grid("none", "100to1")), csv_header) << "nothing to compare";
}

TEST_F(Tables, WriteTwoSeedsForATerminal) {
  add_all();
  EXPECT_EQ(accuracy_text(rows(grid_)),
            "method  ratio         generated  seeds    accuracy %  95 % interval  paper\n"
            "none    100:1                 0      2  62.50 ± 3.54              –   61.8\n"
            "vae     10:1                 45      2  75.00 ± 0.00              –\n"
            "vae     2:1 (3.33:1)        145      2  90.00 ± 7.07              –   91.2\n");
}

/// Speeds differ, and both faults are on the inner race: 5 of 20 windows and 1 are taken for the
/// other fault, but no window for another damaged part.
TEST_F(Tables, ShowTheKindOfDefectForConditions) {
  for (const int seed : {0, 1}) {
    scoring::DiagnosisRecord record = diagnosis("none", "100to1", 0, seed, seed == 0 ? 15 : 19);
    record.info.classes[2].defect = signal::Defect::inner;
    record.info.conditions = {
        {.name = "fast", .shaft_speed_rpm = 1200, .known = true, .test = false, .healthy = true},
        {.name = "slow", .shaft_speed_rpm = 900, .known = false, .test = true, .healthy = true}};
    add(record);
  }
  const run::Grid none = grid("none", "100to1");
  EXPECT_THAT(accuracy_csv(rows(none)),
              HasSubstr(",published,kind_mean,kind_std,kind_ci95_low,kind_ci95_high\n"
                        "cwru,none,wdcnn,100to1,0,2,85.0000,14.1421,,,61.8,100.0000,0.0000,,\n"));
  EXPECT_THAT(accuracy_text(rows(none)),
              HasSubstr("95 % interval         type %\n"
                        "none    100:1          0      2  85.00 ± 14.14              –  100.00 ± "
                        "0.00\n"));
  EXPECT_EQ(rows(none)[0].type_accuracy->mean, 100);
}

TEST_F(Tables, WriteTwoSeedsAsMarkdown) {
  add_all();
  const std::string text = markdown(document(grid_));
  EXPECT_THAT(text,
              StartsWith("# Results on cwru\n\nSplit protocol random; 2 seeds (0, 1), each with"));
  EXPECT_THAT(text, HasSubstr("\n## Mean accuracy on cwru, percent\n\n"));
  EXPECT_THAT(text, HasSubstr("| method | 100:1 |  10:1 | 2:1 (3.33:1) |\n"
                              "|--------|------:|------:|-------------:|\n"
                              "| none   | 62.50 |       |              |\n"
                              "| vae    |       | 75.00 |        90.00 |\n"));
  EXPECT_THAT(
      text, HasSubstr("\n## Accuracy on cwru without generated windows, 100:1, percent (the "
                      "paper's Table 6)\n\n"
                      "| run       |         here | paper |\n"
                      "|-----------|-------------:|------:|\n"
                      "| 1, seed 0 |        60.00 | 61.80 |\n"
                      "| 2, seed 1 |        65.00 | 62.00 |\n"
                      "| 3         |              | 61.70 |\n"
                      "| mean      | 62.50 ± 3.54 | 61.80 |\n"
                      "\n## Accuracy of the methods on cwru, percent (the paper's Table 8)\n\n"
                      "| method | ratio        |         here | paper |\n"
                      "|--------|--------------|-------------:|------:|\n"
                      "| vae    | 10:1         | 75.00 ± 0.00 |       |\n"
                      "|        | 2:1 (3.33:1) | 90.00 ± 7.07 | 91.20 |\n"
                      "\n## Gain of the methods over none on cwru, points (the paper's Fig. 15)\n\n"
                      "Accuracy minus "));
  EXPECT_THAT(text, HasSubstr("| vae    | 10:1         | +12.50 ± 3.54 |        |\n"
                              "|        | 2:1 (3.33:1) | +27.50 ± 3.54 | +29.40 |\n"));
}

/// Values 75, 75, 90 have the deviation 8.6603 and the half-width 4.3027 / sqrt(3) of it; 85, 95,
/// 100 have 7.6376 and 18.973, so the interval would end at 112.31.
TEST_F(Tables, ShowPossibleIntervalsForThreeSeeds) {
  add_all();
  add(diagnosis("none", "100to1", 0, 2, 13));
  add(diagnosis("vae", "10to1", 45, 2, 18));
  add(diagnosis("vae", "2to1", 145, 2, 20));
  add(quality("vae", 2, 0.6));
  const run::Grid three = grid("none vae", "100to1 10to1 2to1", "0 1 2");
  EXPECT_EQ(accuracy_csv(rows(three)),
            csv_header +
                "cwru,none,wdcnn,100to1,0,3,63.3333,2.8868,56.1622,70.5044,61.8\n"
                "cwru,vae,wdcnn,10to1,45,3,80.0000,8.6603,58.4867,100.0000,\n"
                "cwru,vae,wdcnn,2to1,145,3,93.3333,7.6376,74.3604,100.0000,91.2\n");
  const std::string text = markdown(document(three));
  EXPECT_THAT(text, HasSubstr("| mean          |   63.33 ± 2.89 | 61.80 |\n"
                              "| 95 % interval | [56.16, 70.50] |       |\n"));
  EXPECT_THAT(text,
              HasSubstr("| method | ratio        |         here |   95 % interval | paper |\n"
                        "|--------|--------------|-------------:|----------------:|------:|\n"
                        "| vae    | 10:1         | 80.00 ± 8.66 | [58.49, 100.00] |       |\n"
                        "|        | 2:1 (3.33:1) | 93.33 ± 7.64 | [74.36, 100.00] | 91.20 |\n"));
}

/// vae has seed 2 only at 10to1, `none` does not have it, and smote has one cell.
TEST_F(Tables, DescribeARunWithGaps) {
  add_all();
  add(diagnosis("vae", "10to1", 45, 2, 18));
  add(diagnosis("smote", "2to1", 145, 0, 10));
  const auto [all, results] =
      run::collect_held(layout_, grid("none", "100to1", "0"), run::Held(layout_));
  EXPECT_THAT(all.seeds, testing::ElementsAre(0, 1, 2));
  const auto rows = accuracy_rows(all, results, published());
  EXPECT_EQ(accuracy_csv(rows), csv_header +
                                    "cwru,none,wdcnn,100to1,0,2,62.5000,3.5355,,,61.8\n"
                                    "cwru,smote,wdcnn,2to1,145,1,50.0000,,,,\n"
                                    "cwru,vae,wdcnn,10to1,45,3,80.0000,8.6603,58.4867,100.0000,\n"
                                    "cwru,vae,wdcnn,2to1,145,2,90.0000,7.0711,,,91.2\n");
  EXPECT_THAT(accuracy_csv(gain_rows(rows)),
              HasSubstr("cwru,vae,wdcnn,10to1,45,2,12.5000,3.5355,,,\n"));  // of seeds 0 and 1
  const std::string text = markdown(tables(
      all, results, rows, published(), compare_by_classifier(rows, ""), rank_by_classifier(rows)));
  std::string unwrapped = text;
  std::ranges::replace(unwrapped, '\n', ' ');
  EXPECT_THAT(unwrapped, HasSubstr("these have only: none: seeds 0, 1; smote: 2:1 of seed 0; vae: "
                                   "10:1 of seeds 0 to 2, and 2:1 of seeds 0, 1. Each number"));
  EXPECT_THAT(unwrapped, HasSubstr("‡ marks methods with fewer seeds"));
  EXPECT_THAT(text, HasSubstr("| none ‡  | 62.50 |"));
  EXPECT_THAT(text,
              HasSubstr("| smote ‡ | 2:1 (3.33:1) |        50.00 |               – |       |"));
  EXPECT_THAT(quality_csv(all, results), Not(HasSubstr("smote")));
}

/// The mean over the classes is taken for each seed: of 0.5 and 1e-7, and of 0.7 and 1e-7.
TEST_F(Tables, ShowQualityByClassAndMethod) {
  add_baseline();
  add_method("vae");
  add_method("smote");
  add(quality("smote", 0, 0.25));
  add(quality("smote", 1, 0.25));
  const std::string text = markdown(document(grid("vae smote", "10to1")));
  EXPECT_THAT(text, HasSubstr("\n## Quality of the methods on cwru: MMD² (the paper's Fig. 13)\n"));
  EXPECT_THAT(text, HasSubstr("\n## Quality of the methods on cwru: aligned RMSE\n"));
  EXPECT_THAT(text, HasSubstr("| class           |             vae |           smote |\n"
                              "|-----------------|----------------:|----------------:|\n"
                              "| IR              | 0.6000 ± 0.1414 | 0.2500 ± 0.0000 |\n"
                              "| OR              | 0.0000 ± 0.0000 | 0.0000 ± 0.0000 |\n"
                              "| mean of classes | 0.3000 ± 0.0707 | 0.1250 ± 0.0000 |\n"));
  EXPECT_THAT(text, HasSubstr("| IR              | 1.200 ± 0.283 | 0.500 ± 0.000 |\n"
                              "| OR              | 1.000 ± 0.000 | 1.000 ± 0.000 |\n"
                              "| mean of classes | 1.100 ± 0.141 | 0.750 ± 0.000 |\n"));
}

TEST_F(Tables, HaveNoSpreadForOneSeed) {
  add_all();
  const run::Grid one = grid("none vae", "100to1 10to1", "1");
  EXPECT_EQ(accuracy_csv(rows(one)), csv_header +
                                         "cwru,none,wdcnn,100to1,0,1,65.0000,,,,61.8\n"
                                         "cwru,vae,wdcnn,10to1,45,1,75.0000,,,,\n");
  EXPECT_EQ(gains(one), csv_header + "cwru,vae,wdcnn,10to1,45,1,10.0000,,,,\n");
  EXPECT_THAT(quality_csv(one, collect(layout_, one)), HasSubstr("\ncwru,vae,IR,mmd,1,0.7,\n"));
  EXPECT_THAT(markdown(document(one)),
              AllOf(HasSubstr("; 1 seed (1), each"), HasSubstr("| 1, seed 1 | 65.00 | 61.80 |"),
                    HasSubstr("| vae    | 10:1  | 75.00 |\n\n"),
                    HasSubstr("| vae    | 10:1  | +10.00 |\n\n"),
                    HasSubstr("| IR              | "
                              "0.7000 |\n")));
}

TEST_F(Tables, CoverOneSideOfTheGrid) {
  add_all();
  const std::string none = markdown(document(grid("none", "100to1")));
  EXPECT_THAT(none, AllOf(HasSubstr("Accuracy on cwru without"), Not(HasSubstr("the methods"))));
  const std::string vae = markdown(document(grid("vae", "10to1")));
  EXPECT_THAT(vae, AllOf(HasSubstr("Accuracy of the methods"), Not(HasSubstr("without generated")),
                         Not(HasSubstr("## Gain"))));
  EXPECT_EQ(quality_csv(grid("none", "100to1"), {}),
            "dataset,method,class,metric,seeds,mean,std\n");
  // Requested, but without a cell at these ratios.
  EXPECT_THAT(
      markdown(document(grid("none vae", "100to1"))),
      AllOf(HasSubstr("Quality of the methods"), Not(HasSubstr("Accuracy of the methods"))));
}

TEST_F(Tables, MarkTheCeilingAndOmitItsQuality) {
  add_all();
  add(diagnosis("oracle", "2to1", 145, 0, 20));
  add(diagnosis("oracle", "2to1", 145, 1, 20));
  const run::Grid with_oracle = grid("none vae oracle", "100to1 2to1");
  const std::string text = markdown(document(with_oracle));
  EXPECT_THAT(text, AllOf(HasSubstr("| oracle (ceiling) | 2:1 (3.33:1) | 100.00 ± 0.00 |"),
                          HasSubstr("The oracle is a ceiling")));
  EXPECT_THAT(accuracy_text(rows(with_oracle)), HasSubstr("\noracle (ceiling)  2:1"));
  EXPECT_THAT(quality_csv(with_oracle, collect(layout_, with_oracle)), Not(HasSubstr("oracle")));
  EXPECT_THAT(markdown(document(grid_)), Not(HasSubstr("oracle is")));
}

TEST_F(Tables, MarkDifferencesBeyondChance) {
  add_baseline();
  add_method("vae");
  add_method("piae-dt");
  const std::string text = markdown(document(grid("none vae piae-dt", "100to1 10to1 2to1")));
  EXPECT_THAT(text, HasSubstr("\n## Accuracy minus that of piae-dt on cwru\n"));
  EXPECT_THAT(text, HasSubstr("\n## Average ranks on cwru\n"));
  EXPECT_THAT(text, HasSubstr("| vae    | 10:1         |  +0.00 ± 0.00 |"));
}

TEST_F(Tables, ShowTheAblationSeparately) {
  add_baseline();
  for (const char* method : {"vae", "piae-dt", "ae"}) add_method(method);
  const std::string text = markdown(document(grid("none vae piae-dt ae", "100to1 2to1")));
  EXPECT_THAT(text, HasSubstr("| vae     | 2:1 (3.33:1) | 90.00 ± 7.07 | 91.20 |\n"
                              "| piae-dt | 2:1 (3.33:1) | 90.00 ± 7.07 | 93.70 |\n\n"));
  EXPECT_THAT(text,
              HasSubstr("\n## Accuracy of the ablations on cwru, percent (the paper's Table 10)\n\n"
                        "Model 1: piae-dt, the full model; Model 2: ae, without the physics.\n\n"
                        "| method            | ratio        |         here | paper |\n"
                        "|-------------------|--------------|-------------:|------:|\n"
                        "| piae-dt (Model 1) | 2:1 (3.33:1) | 90.00 ± 7.07 | 93.70 |\n"
                        "| ae (Model 2)      | 2:1 (3.33:1) | 90.00 ± 7.07 | 91.70 |\n"));
  EXPECT_THAT(
      text, HasSubstr("## Gain of the ablations over none on cwru, points (the paper's Fig. 18)"));
  EXPECT_THAT(text, HasSubstr("## Quality of the ablations on cwru: RMSE (the paper's Fig. 16)"));
}

TEST_F(Tables, NameOutlookModelsWithoutANumber) {
  add_baseline();
  for (const char* method : {"piae-dt", "ae", "piae-dt-tcn"}) add_method(method);
  const std::string text = markdown(document(grid("none piae-dt ae piae-dt-tcn", "100to1 2to1")));
  EXPECT_THAT(text, HasSubstr("Model 1: piae-dt, the full model; Model 2: ae, without the physics; "
                              "outlook: piae-dt-tcn, with a\n"
                              "temporal convolutional auto-encoder.\n\n"));
  EXPECT_THAT(text, HasSubstr("| ae (Model 2)          | 2:1 (3.33:1) | 90.00 ± 7.07 | 91.70 |\n"
                              "| piae-dt-tcn (outlook) | 2:1 (3.33:1) | 90.00 ± 7.07 |       |\n"));
}

class TablesOfTheStandIn : public Tables {
 protected:
  TablesOfTheStandIn() : Tables("hit-sm") {}
};

TEST_F(TablesOfTheStandIn, AreNotPresentedAsThePapers) {
  add_all();
  for (const std::string& text : {markdown(document(grid_)), latex(document(grid_))}) {
    EXPECT_THAT(text, HasSubstr("Results on hit-sm, which stands in for HFHP\n"));
    EXPECT_THAT(text, HasSubstr("for orientation only"));
    EXPECT_THAT(text, Not(HasSubstr("(the paper's")));
  }
  for (const Section& section : document(grid_).sections) {
    EXPECT_THAT(section.findings.empty() ? section.note : section.findings.front(),
                HasSubstr("hit-sm stands in for HFHP."));
  }
}

TEST_F(TablesOfTheStandIn, ShowThePapersValuesButNotInCsv) {
  add_all();
  const std::string text = markdown(document(grid_));
  EXPECT_THAT(text, HasSubstr("| run       |         here | paper, HFHP |\n"
                              "|-----------|-------------:|------------:|\n"
                              "| 1, seed 0 |        60.00 |       61.00 |\n"));
  EXPECT_THAT(text, HasSubstr("|        | 2:1 (3.33:1) | 90.00 ± 7.07 |       90.86 |\n"));
  EXPECT_THAT(text, HasSubstr("|        | 2:1 (3.33:1) | +27.50 ± 3.54 |      +28.86 |\n"));
  EXPECT_EQ(accuracy_csv(rows(grid_)), csv_header +
                                           "hit-sm,none,wdcnn,100to1,0,2,62.5000,3.5355,,,\n"
                                           "hit-sm,vae,wdcnn,10to1,45,2,75.0000,0.0000,,,\n"
                                           "hit-sm,vae,wdcnn,2to1,145,2,90.0000,7.0711,,,\n");
}

class TablesOfAnotherDataset : public Tables {
 protected:
  TablesOfAnotherDataset() : Tables("my_rig_100") {}
};

TEST_F(TablesOfAnotherDataset, DoNotMentionThePaper) {
  add_all();
  const std::string text = markdown(document(grid_));
  EXPECT_THAT(text, AllOf(StartsWith("# Results on my_rig_100\n"), Not(HasSubstr("paper |")),
                          Not(HasSubstr("the paper's"))));
}

/// Counts a character in a LaTeX text without a backslash before it.
std::size_t bare(const std::string& text, char c) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\') {
      ++i;
    } else if (text[i] == c) {
      ++found;
    }
  }
  return found;
}

/// Checks for text that LaTeX refuses or silently drops. A table row must be one line.
void expect_sound_latex(const std::string& text) {
  EXPECT_EQ(bare(text, '{'), bare(text, '}'));
  std::istringstream lines(text);
  std::size_t columns = 0;
  std::size_t rows = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string begin = "\\begin{tabular}{";
    if (line.starts_with(begin)) columns = line.size() - begin.size() - 1;
    if (line.starts_with("% ")) continue;
    EXPECT_EQ(bare(line, '$') % 2, 0U) << line;
    EXPECT_EQ(bare(line, '#') + bare(line, '_') + bare(line, '~'), 0U) << line;
    EXPECT_TRUE(bare(line, '%') == 0 || line.ends_with("}{%")) << line;
    EXPECT_TRUE(bare(line, '^') == 0 || line.find("$^2$") != std::string::npos) << line;
    const bool is_row = line.ends_with(" \\\\");
    EXPECT_EQ(bare(line, '&'), is_row ? columns - 1 : 0) << line;
    rows += is_row ? 1 : 0;
  }
  EXPECT_GT(rows, 0U);
}

TEST_F(TablesOfAnotherDataset, AreValidLatexForAnyNames) {
  add_all();
  const std::string text = latex(document(grid_));
  expect_sound_latex(text);
  EXPECT_THAT(text, StartsWith("% Results on my\\_rig\\_100\n"));
  EXPECT_THAT(text, HasSubstr("\\label{tab:my-rig-100-quality-methods-spectral-distance-db}"));
}

TEST_F(Tables, AreValidLatex) {
  add_baseline();
  for (const char* method : {"vae", "piae-dt", "ae"}) add_method(method);
  const std::string text = latex(document(grid("none vae piae-dt ae", "100to1 10to1 2to1")));
  expect_sound_latex(text);
  EXPECT_THAT(text, HasSubstr("\\begin{tabular}{llrr}\n"
                              "  \\toprule\n"
                              "  method & ratio & here & paper \\\\\n"
                              "  \\midrule\n"
                              "  vae & 10:1 & 75.00 $\\pm$ 0.00 &  \\\\\n"
                              "   & 2:1 (3.33:1) & 90.00 $\\pm$ 7.07 & 91.20 \\\\\n"
                              "  \\addlinespace\n"
                              "  piae-dt & 10:1 &"));
}

}  // namespace
}  // namespace piae::report
