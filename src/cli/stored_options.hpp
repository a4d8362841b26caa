#pragma once

#include <functional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "cli/options.hpp"

namespace piae::cli {

/// A table of options that an artefact stores, too. One row says what command line, artefact and
/// checks need. If a name holds "-from", the next row is the end of that range. The attribute has
/// the name of the option, with '_' for '-', unless `stored` is given. The values must outlive the
/// table.
class StoredOptions {
 public:
  /// The rows that follow are stored in this group of the artefact.
  void in(const std::string& group) { group_ = group; }
  void add(const std::string& name, double& value, const Range& range, const std::string& help,
           const std::string& stored = "") {
    add_row(name, help, stored, range).number = &value;
  }
  void add(const std::string& name, int& value, const Range& range, const std::string& help,
           const std::string& stored = "") {
    add_row(name, help, stored, range).whole = &value;
  }
  template <class E>
  void add(const std::string& name, E& value, const std::vector<Word<E>>& words,
           const std::string& help, const std::string& stored = "") {
    Row& row = add_row(name, help, stored, {});
    for (const Word<E>& word : words) row.words.emplace_back(word.text);
    row.place = [=, &value] {
      std::size_t i = 0;
      while (words[i].value != value) ++i;
      return i;
    };
    row.take = [=, &value](std::size_t i) { value = words[i].value; };
  }

  /// Adds an option for each row.
  void bind(const Options& command) const;
  /// Throws Error(usage) for a range whose end is below its beginning.
  void require_order() const;
  void write(artefact::Writer& writer) const;
  /// Throws artefact::Refusal for a value that the option would not take, and for a range whose
  /// end is below its beginning.
  void read(const artefact::Reader& reader) const;

 private:
  /// Exactly one of `number`, `whole` and `words` is there.
  struct Row {
    std::string name, group, attribute, help;
    Range range;
    double* number = nullptr;
    int* whole = nullptr;
    std::vector<std::string> words = {};
    std::function<std::size_t()> place = {};     ///< of the value among the words
    std::function<void(std::size_t)> take = {};  ///< sets the value to a word
  };

  Row& add_row(const std::string& name, const std::string& help, const std::string& stored,
               const Range& range);
  /// The first range whose end is below its beginning; null if there is none.
  [[nodiscard]] const Row* first_reversed() const;

  std::string group_;
  std::vector<Row> rows_;
};

}  // namespace piae::cli
