#include "figures/catalogue.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "diagnosis/catalogue.hpp"

namespace piae::figures {
namespace {

namespace fs = std::filesystem;

const fs::path scripts = fs::path(PIAE_SOURCE) / "pipeline" / "figures";

TEST(Catalogue, HasAScriptForEachFigure) {
  for (const Figure& figure : catalogue()) {
    EXPECT_TRUE(fs::exists(scripts / (std::string(figure.name) + ".gp"))) << figure.name;
  }
}

/// True if the first lines of a script state that others load it, or that it draws a table.
bool is_no_figure(const fs::path& script) {
  std::ifstream file(script);
  std::string text(300, ' ');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text.find("Loaded by") != std::string::npos ||
         text.find("Shared by all") != std::string::npos ||
         text.find("# Draws a table") != std::string::npos;
}

TEST(Catalogue, HasAFigureForEachScript) {
  std::set<std::string> names;
  for (const Figure& figure : catalogue()) names.insert(figure.name);
  for (const auto& entry : fs::directory_iterator(scripts)) {
    if (entry.path().extension() != ".gp" || is_no_figure(entry.path())) continue;
    EXPECT_TRUE(names.contains(entry.path().stem())) << entry.path();
  }
}

// gnuplot cannot ask the catalogue of classifiers.
TEST(Style, MarksTheClassifiersThatSeeD) {
  std::ifstream file(scripts / "style.gp");
  const std::string style{std::istreambuf_iterator<char>(file), {}};
  for (const diagnosis::Classifier& classifier : diagnosis::classifiers()) {
    const std::string name = std::string("classifier eq \"") + classifier.name + '"';
    EXPECT_EQ(style.find(name) != std::string::npos, classifier.adapts()) << name;
  }
}

TEST(Catalogue, HasACaptionAndASourceForEachFigure) {
  std::set<std::string> names;
  for (const Figure& figure : catalogue()) {
    EXPECT_TRUE(names.insert(figure.name).second) << "twice: " << figure.name;
    EXPECT_NE(std::string(figure.title), "");
    EXPECT_NE(std::string(figure.caption), "");
    EXPECT_NE(std::string(figure.from), "");
  }
}

}  // namespace
}  // namespace piae::figures
