#include "report/document.hpp"

#include <cctype>
#include <sstream>

#include "text/escape.hpp"

namespace piae::report {

namespace {

/// Limit of a line, so that a document can be read in a terminal and next to a source file.
constexpr std::size_t widest_line = 100;

/// Breaks a paragraph into lines of at most `widest_line` bytes, each ended by a line feed. A
/// longer word gets its own line.
std::string wrapped(const std::string& paragraph) {
  std::istringstream words(paragraph);
  std::string text;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > widest_line) {
      text += line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return text + line + '\n';
}

/// Returns a label of letters, digits and hyphens, because LaTeX refuses some other characters.
std::string label_of(const Document& document, const Section& section) {
  std::string label = document.key + "-" + section.key;
  for (char& c : label) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
  }
  return label;
}

/// Returns the findings and the note as one paragraph.
std::string text_of(const Section& section) {
  std::string text;
  for (const std::string& finding : section.findings) text += finding + " ";
  return text + section.note;
}

std::string latex_float(const Document& document, const Section& section) {
  const std::string note = text_of(section).empty() ? "" : " " + text_of(section);
  return "\\begin{table}\n\\centering\n" +
         wrapped("\\caption{" + text::latex_text(section.title + "." + note) + "}") +
         "\\label{tab:" + label_of(document, section) +
         "}\n"
         // Shrinks a table that is wider or higher than the text, and leaves room for the caption.
         "\\resizebox*{!}{\\ifdim\\totalheight>0.8\\textheight 0.8\\textheight\\else"
         "\\totalheight\\fi}{%\n"
         "\\resizebox{\\ifdim\\width>\\linewidth\\linewidth\\else\\width\\fi}{!}{%\n" +
         section.table.latex() + "}}\n\\end{table}\n";
}

}  // namespace

std::string markdown(const Document& document) {
  std::string text = "# " + text::markdown_text(document.title) + '\n';
  for (const std::string& paragraph : document.paragraphs) {
    text += '\n' + wrapped(text::markdown_text(paragraph));
  }
  for (const Section& section : document.sections) {
    text += "\n## " + text::markdown_text(section.title) + "\n\n";
    const std::string prose = text_of(section);
    if (!prose.empty()) text += wrapped(text::markdown_text(prose)) + '\n';
    text += section.table.markdown(widest_line);
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
