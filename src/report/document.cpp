#include "report/document.hpp"

#include <cctype>
#include <sstream>

#include "text/escape.hpp"

namespace piae::report {

namespace {

/// Breaks a paragraph into lines of at most 100 bytes (a longer word has a line of its own), each
/// ended by a line feed.
std::string wrapped(const std::string& paragraph) {
  constexpr std::size_t width = 100;
  std::istringstream words(paragraph);
  std::string text;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      text += line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return text + line + '\n';
}

/// A label holds letters, digits and hyphens only: LaTeX does not take all other characters.
std::string label_of(const Document& document, const Section& section) {
  std::string label = document.key + "-" + section.key;
  for (char& c : label) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  }
  return label;
}

std::string latex_float(const Document& document, const Section& section) {
  const std::string note = section.note.empty() ? "" : " " + section.note;
  return "\\begin{table}\n\\centering\n" +
         wrapped("\\caption{" + text::latex_text(section.title + "." + note) + "}") +
         "\\label{tab:" + label_of(document, section) +
         "}\n"
         // A table that is wider than the text is made as wide as that.
         "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n" +
         section.table.latex() + "}\n\\end{table}\n";
}

}  // namespace

std::string markdown(const Document& document) {
  std::string text = "# " + text::markdown_text(document.title) + '\n';
  for (const std::string& paragraph : document.paragraphs) {
    text += '\n' + wrapped(text::markdown_text(paragraph));
  }
  for (const Section& section : document.sections) {
    text += "\n## " + text::markdown_text(section.title) + "\n\n";
    if (!section.note.empty()) text += wrapped(text::markdown_text(section.note)) + '\n';
    text += section.table.markdown();
  }
  return text;
}

std::string latex(const Document& document) {
  std::string text = "% " + text::latex_text(document.title) +
                     "\n"
                     "% For \\input. In the preamble: \\usepackage{booktabs,graphicx}\n";
  for (const std::string& paragraph : document.paragraphs) {
    text += '\n' + wrapped(text::latex_text(paragraph));
  }
  for (const Section& section : document.sections) text += '\n' + latex_float(document, section);
  return text;
}

}  // namespace piae::report
