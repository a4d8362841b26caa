#include "text/file.hpp"

#include <span>

#include "artefact/file.hpp"
#include "base/error.hpp"

namespace piae::text {

std::string read_file(const std::filesystem::path& file) {
  const Bytes bytes = artefact::read_file(file);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

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
  if (std::filesystem::exists(file.path) && read_file(file.path) == file.text) return;
  artefact::write_file_atomically(file.path, std::as_bytes(std::span(file.text)));
}

}  // namespace piae::text
