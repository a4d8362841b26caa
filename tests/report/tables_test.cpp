#include "report/tables.hpp"

#include <sstream>

#include "report/published.hpp"
#include "report/quality_table.hpp"
#include "support/stored_run.hpp"

namespace piae::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

const std::string csv_header =
    "dataset,method,ratio,generated_per_class,seeds,mean,std,ci95_low,ci95_high,published\n";

class Tables : public StoredRun {
 protected:
  explicit Tables(const std::string& dataset = "cwru") : StoredRun(dataset) {
    folder_.write("table6-7-baseline.csv",
                  "dataset,run1,run2,run3,average\ncwru,61.8,62,61.7,61.8\nhfhp,61,62,63,62\n");
    folder_.write("table8-9-methods.csv",
                  "dataset,method,2to1\ncwru,vae,91.2\ncwru,piae-dt,93.7\nhfhp,vae,90.86\n");
    folder_.write("table10-11-ablation.csv",
                  "dataset,model,2to1\ncwru,model1,93.7\ncwru,model2,91.7\n");
  }
  [[nodiscard]] Published published() const { return Published(folder_.path()); }
  [[nodiscard]] std::vector<AccuracyRow> rows(const run::Grid& grid) const {
    return accuracy_rows(grid, collect(layout_, grid), published());
  }
  [[nodiscard]] Document document(const run::Grid& grid) const {
    return tables(grid, collect(layout_, grid), rows(grid), published(),
                  compare_methods(rows(grid), ""), rank_methods(rows(grid)));
  }
  [[nodiscard]] std::string gains(const run::Grid& grid) const {
    return accuracy_csv(gain_rows(rows(grid)));
  }
};

/// Of two values a, b the deviation is |a - b| / sqrt(2), and the interval's half 12.7062 |a - b|
/// / 2.
TEST_F(Tables, OfTwoSeedsAreWrittenAsCsv) {
  add_all();
  EXPECT_EQ(accuracy_csv(rows(grid_)),
            csv_header +
                "cwru,none,100to1,0,2,62.5000,3.5355,30.7345,94.2655,61.8\n"
                "cwru,vae,10to1,45,2,75.0000,0.0000,75.0000,75.0000,\n"
                "cwru,vae,2to1,145,2,90.0000,7.0711,26.4690,153.5310,91.2\n");
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

/// Paired by seed: 75 - 60 and 75 - 65; 85 - 60 and 95 - 65. Published: 91.2 - 61.8.
TEST_F(Tables, OfGainsArePairedBySeed) {
  add_all();
  EXPECT_EQ(gains(grid_), csv_header +
                              "cwru,vae,10to1,45,2,12.5000,3.5355,-19.2655,44.2655,\n"
                              "cwru,vae,2to1,145,2,27.5000,3.5355,-4.2655,59.2655,29.4\n");
  EXPECT_EQ(gains(grid("vae", "10to1")), csv_header) << "nothing to compare with";
  EXPECT_EQ(gains(grid("none", "100to1")), csv_header) << "nothing to compare";
}

TEST_F(Tables, OfTwoSeedsAreWrittenForATerminal) {
  add_all();
  EXPECT_EQ(accuracy_text(rows(grid_)),
            "method  ratio         generated  seeds    accuracy %    95 % interval  paper\n"
            "none    100:1                 0      2  62.50 ± 3.54   [30.73, 94.27]   61.8\n"
            "vae     10:1                 45      2  75.00 ± 0.00   [75.00, 75.00]\n"
            "vae     2:1 (3.33:1)        145      2  90.00 ± 7.07  [26.47, 153.53]   91.2\n");
}

TEST_F(Tables, OfTwoSeedsAreWrittenAsMarkdown) {
  add_all();
  const std::string text = markdown(document(grid_));
  EXPECT_THAT(text, StartsWith("# Results on cwru\n\nSplit protocol random; 2 seeds, each"));
  EXPECT_THAT(
      text,
      HasSubstr("\n## Accuracy on cwru without generated windows, 100:1, percent (the "
                "paper's Table 6)\n\n"
                "|                 | run 1 | run 2 | run 3 |         mean |  95 % interval |\n"
                "|-----------------|------:|------:|------:|-------------:|---------------:|\n"
                "| here, seeds 0 1 | 60.00 | 65.00 |       | 62.50 ± 3.54 | [30.73, 94.27] |\n"
                "| paper           | 61.80 | 62.00 | 61.70 |        61.80 |                |\n"
                "\n## Accuracy of the methods on cwru, percent (the paper's Table 8)\n\n"
                "| method |       |           10:1 |    2:1 (3.33:1) |\n"
                "|--------|-------|---------------:|----------------:|\n"
                "| vae    | here  |   75.00 ± 0.00 |    90.00 ± 7.07 |\n"
                "|        | 95 %  | [75.00, 75.00] | [26.47, 153.53] |\n"
                "|        | paper |                |           91.20 |\n"
                "\n## Gain of the methods over none on cwru, points (the paper's Fig. 15)\n\n"
                "Accuracy minus "));
  EXPECT_THAT(text, HasSubstr("| vae    | here  |    +12.50 ± 3.54 |   +27.50 ± 3.54 |\n"
                              "|        | 95 %  | [-19.27, +44.27] | [-4.27, +59.27] |\n"
                              "|        | paper |                  |          +29.40 |\n"));
}

/// The mean over the classes is one of each seed: of 0.5 and 1e-7, of 0.7 and 1e-7.
TEST_F(Tables, OfQualityHaveAClassARowAndAMethodAColumn) {
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

TEST_F(Tables, OfOneSeedHaveNoSpread) {
  add_all();
  const run::Grid one = grid("none vae", "100to1 10to1", "1");
  EXPECT_EQ(accuracy_csv(rows(one)), csv_header +
                                         "cwru,none,100to1,0,1,65.0000,,,,61.8\n"
                                         "cwru,vae,10to1,45,1,75.0000,,,,\n");
  EXPECT_EQ(gains(one), csv_header + "cwru,vae,10to1,45,1,10.0000,,,,\n");
  EXPECT_THAT(quality_csv(one, collect(layout_, one)), HasSubstr("\ncwru,vae,IR,mmd,1,0.7,\n"));
  EXPECT_THAT(
      markdown(document(one)),
      AllOf(HasSubstr("; 1 seed, each"),
            HasSubstr("| here, seed 1 | 65.00 |       |       | 65.00 |"),
            HasSubstr("| vae    | here | 75.00 |\n\n"), HasSubstr("| vae    | here | +10.00 |\n\n"),
            HasSubstr("| IR              | "
                      "0.7000 |\n")));
}

TEST_F(Tables, AreMadeOfOneSideOfTheGridToo) {
  add_all();
  const std::string none = markdown(document(grid("none", "100to1")));
  EXPECT_THAT(none, AllOf(HasSubstr("Accuracy on cwru without"), Not(HasSubstr("the methods"))));
  const std::string vae = markdown(document(grid("vae", "10to1")));
  EXPECT_THAT(vae, AllOf(HasSubstr("Accuracy of the methods"), Not(HasSubstr("without generated")),
                         Not(HasSubstr("## Gain"))));
  EXPECT_EQ(quality_csv(grid("none", "100to1"), {}),
            "dataset,method,class,metric,seeds,mean,std\n");
  // Asked for, but without a cell at these ratios.
  EXPECT_THAT(
      markdown(document(grid("none vae", "100to1"))),
      AllOf(HasSubstr("Quality of the methods"), Not(HasSubstr("Accuracy of the methods"))));
}

TEST_F(Tables, MarkTheCeilingWhichHasNoQuality) {
  add_all();
  add(diagnosis("oracle", "2to1", 145, 0, 20));
  add(diagnosis("oracle", "2to1", 145, 1, 20));
  const run::Grid with_oracle = grid("none vae oracle", "100to1 2to1");
  const std::string text = markdown(document(with_oracle));
  EXPECT_THAT(text, AllOf(HasSubstr("| oracle (ceiling) | here  |    100.00 ± 0.00 |"),
                          HasSubstr("The oracle is no method but a ceiling")));
  EXPECT_THAT(accuracy_text(rows(with_oracle)), HasSubstr("\noracle (ceiling)  2:1"));
  EXPECT_THAT(quality_csv(with_oracle, collect(layout_, with_oracle)), Not(HasSubstr("oracle")));
  EXPECT_THAT(markdown(document(grid_)), Not(HasSubstr("oracle is")));
}

TEST_F(Tables, SayWhatIsMoreThanChance) {
  add_baseline();
  add_method("vae");
  add_method("piae-dt");
  const std::string text = markdown(document(grid("none vae piae-dt", "100to1 10to1 2to1")));
  EXPECT_THAT(text, HasSubstr("\n## Accuracy minus that of piae-dt on cwru\n"));
  EXPECT_THAT(text, HasSubstr("\n## Average ranks on cwru\n"));
  EXPECT_THAT(text, HasSubstr("| vae    | difference |     +0.00 ± 0.00 |"));
}

TEST_F(Tables, OfTheAblationStandApart) {
  add_baseline();
  for (const char* method : {"vae", "piae-dt", "ae"}) add_method(method);
  const std::string text = markdown(document(grid("none vae piae-dt ae", "100to1 2to1")));
  EXPECT_THAT(text, HasSubstr("| vae     | here  |    90.00 ± 7.07 |\n"
                              "|         | 95 %  | [26.47, 153.53] |\n"
                              "|         | paper |           91.20 |\n"
                              "| piae-dt | here  |    90.00 ± 7.07 |\n"
                              "|         | 95 %  | [26.47, 153.53] |\n"
                              "|         | paper |           93.70 |\n\n"));
  EXPECT_THAT(text,
              HasSubstr("\n## Accuracy of the ablations on cwru, percent (the paper's Table 10)\n\n"
                        "Model 1: piae-dt, the full model; Model 2: ae, without the physics.\n\n"
                        "| method            |       |    2:1 (3.33:1) |\n"
                        "|-------------------|-------|----------------:|\n"
                        "| piae-dt (Model 1) | here  |    90.00 ± 7.07 |\n"
                        "|                   | 95 %  | [26.47, 153.53] |\n"
                        "|                   | paper |           93.70 |\n"
                        "| ae (Model 2)      | here  |    90.00 ± 7.07 |\n"
                        "|                   | 95 %  | [26.47, 153.53] |\n"
                        "|                   | paper |           91.70 |\n"));
  EXPECT_THAT(
      text, HasSubstr("## Gain of the ablations over none on cwru, points (the paper's Fig. 18)"));
  EXPECT_THAT(text, HasSubstr("## Quality of the ablations on cwru: RMSE (the paper's Fig. 16)"));
}

class TablesOfTheStandIn : public Tables {
 protected:
  TablesOfTheStandIn() : Tables("hit-sm") {}
};

TEST_F(TablesOfTheStandIn, AreNeverTakenForThePapers) {
  add_all();
  for (const std::string& text : {markdown(document(grid_)), latex(document(grid_))}) {
    EXPECT_THAT(text, HasSubstr("Results on hit-sm, which stands in for HFHP\n"));
    EXPECT_THAT(text, HasSubstr("for orientation only"));
    EXPECT_THAT(text, Not(HasSubstr("(the paper's")));
  }
  for (const Section& section : document(grid_).sections) {
    EXPECT_THAT(section.title, testing::EndsWith("hit-sm stands in for HFHP)"));
  }
}

TEST_F(TablesOfTheStandIn, HaveThePapersFiguresBesideThemButNotInTheirCsv) {
  add_all();
  const std::string text = markdown(document(grid_));
  EXPECT_THAT(text, HasSubstr("| here, seeds 0 1 | 60.00 | 65.00 |       | 62.50 ± 3.54 | [30.73, "
                              "94.27] |\n"
                              "| paper, HFHP     | 61.00 | 62.00 | 63.00 |        62.00 |"));
  EXPECT_THAT(text, HasSubstr("|        | paper, HFHP |                |           90.86 |\n"));
  EXPECT_THAT(text, HasSubstr("|        | paper, HFHP |                  |          +28.86 |\n"));
  EXPECT_EQ(accuracy_csv(rows(grid_)),
            csv_header +
                "hit-sm,none,100to1,0,2,62.5000,3.5355,30.7345,94.2655,\n"
                "hit-sm,vae,10to1,45,2,75.0000,0.0000,75.0000,75.0000,\n"
                "hit-sm,vae,2to1,145,2,90.0000,7.0711,26.4690,153.5310,\n");
}

class TablesOfAnotherDataset : public Tables {
 protected:
  TablesOfAnotherDataset() : Tables("100%_{mine}") {}
};

TEST_F(TablesOfAnotherDataset, DoNotMentionThePapers) {
  add_all();
  const std::string text = markdown(document(grid_));
  EXPECT_THAT(text, AllOf(StartsWith("# Results on 100%_{mine}\n"), Not(HasSubstr("| paper")),
                          Not(HasSubstr("the paper's"))));
}

/// How often a character stands in a LaTeX text without a backslash before it.
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

/// What LaTeX would stop at, or drop without a word. A row of a table is a line.
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
    EXPECT_TRUE(bare(line, '%') == 0 || line.ends_with("{!}{%")) << line;
    EXPECT_TRUE(bare(line, '^') == 0 || line.find("$^2$") != std::string::npos) << line;
    const bool is_row = line.ends_with(" \\\\");
    EXPECT_EQ(bare(line, '&'), is_row ? columns - 1 : 0) << line;
    rows += is_row ? 1 : 0;
  }
  EXPECT_GT(rows, 0U);
}

TEST_F(TablesOfAnotherDataset, AreSoundLatexWhateverTheNames) {
  add_all();
  const std::string text = latex(document(grid_));
  expect_sound_latex(text);
  EXPECT_THAT(text, StartsWith("% Results on 100\\%\\_\\{mine\\}\n"));
  EXPECT_THAT(text, HasSubstr("\\label{tab:100---mine--quality-methods-spectral-distance-db}"));
}

TEST_F(Tables, AreSoundLatex) {
  add_baseline();
  for (const char* method : {"vae", "piae-dt", "ae"}) add_method(method);
  const std::string text = latex(document(grid("none vae piae-dt ae", "100to1 10to1 2to1")));
  expect_sound_latex(text);
  EXPECT_THAT(text, HasSubstr("\\begin{tabular}{llrr}\n"
                              "  \\toprule\n"
                              "  method &  & 10:1 & 2:1 (3.33:1) \\\\\n"
                              "  \\midrule\n"
                              "  vae & here & 75.00 $\\pm$ 0.00 & 90.00 $\\pm$ 7.07 \\\\\n"
                              "   & 95 \\% & {[}75.00, 75.00{]} & {[}26.47, 153.53{]} \\\\\n"
                              "   & paper &  & 91.20 \\\\\n"
                              "  \\addlinespace\n"
                              "  piae-dt & here &"));
}

}  // namespace
}  // namespace piae::report
