#include "text/file.hpp"

#include <algorithm>
#include <span>

#include "artefact/file.hpp"
#include "base/error.hpp"

namespace piae::text {

void save_all(const std::vector<File>& files) {
  std::size_t done = 0;
  try {
    for (; done < files.size(); ++done) {
      artefact::write_file_atomically(files[done].path, std::as_bytes(std::span(files[done].text)));
    }
  } catch (const Error&) {
    for (std::size_t i = 0; i < done; ++i) artefact::remove_file(files[i].path);
    throw;
  }
}

void save_if_changed(const File& file) {
  const auto text = std::as_bytes(std::span(file.text));
  if (std::filesystem::exists(file.path) &&
      std::ranges::equal(artefact::read_file(file.path), text)) {
    return;
  }
  artefact::write_file_atomically(file.path, text);
}

}  // namespace piae::text
