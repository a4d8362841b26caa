#pragma once

#include <functional>
#include <string>
#include <vector>

#include "artefact/reader.hpp"
#include "artefact/writer.hpp"
#include "cli/options.hpp"

namespace piae::cli {

/// A table of options that an artefact stores, too. One row defines option, attribute and check. A
/// name with "-from" makes the next row the end of that range. The attribute has the name of the
/// option, with '_' for '-', unless `stored` is given. The values must outlive the table.
class StoredOptions {
 public:
  /// Sets the group of the artefact that holds the rows added next.
  void in(const std::string& group) { group_ = group; }
  /// Adds a row. bind(), write() and read() use its value later.
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
  /// Throws Error(usage) if the end of a range is below its beginning.
  void require_order() const;
  void write(artefact::Writer& writer) const;
  /// Throws artefact::Refusal for a value that the option would reject, and for a range whose end
  /// is below its beginning.
  void read(const artefact::Reader& reader) const;

 private:
  /// Exactly one of `number`, `whole` and `words` is set.
  struct Row {
    std::string name, group, attribute, help;
    Range range;
    double* number = nullptr;
    int* whole = nullptr;
    std::vector<std::string> words = {};
    std::function<std::size_t()> place = {};     ///< index of the value among the words
    std::function<void(std::size_t)> take = {};  ///< sets the value to a word
  };

  Row& add_row(const std::string& name, const std::string& help, const std::string& stored,
               const Range& range);
  /// Returns the first range whose end is below its beginning; null if all are in order.
  [[nodiscard]] const Row* first_reversed() const;

  std::string group_;
  std::vector<Row> rows_;
};

}  // namespace piae::cli
