#include "formats/files.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"
#include "formats/csv.hpp"
#include "formats/mat.hpp"
#include "formats/npy.hpp"
#include "formats/wav.hpp"

namespace piae::formats {

namespace {

namespace fs = std::filesystem;

struct Format {
  const char* ending;
  std::string (*write)(const Exported& exported);
  bool samples_alone;  ///< true if the facts need a file of their own
};

std::string npy_of(const Exported& exported) { return npy(exported.windows); }

constexpr std::array<Format, 4> formats{{
    {".csv", csv, false},
    {".mat", mat, false},
    {".npy", npy_of, true},
    {".wav", wav, true},
}};

const Format& format_of(const fs::path& output) {
  const std::string ending = output.extension();
  const auto* const found = std::ranges::find(formats, ending, &Format::ending);
  if (found != formats.end()) return *found;
  throw Error(Exit::usage,
              output.string() + ": must end in .csv, .mat, .npy or .wav, which selects the format");
}

}  // namespace

std::vector<fs::path> paths_of(const fs::path& output) {
  std::vector<fs::path> paths{output};
  if (format_of(output).samples_alone) {
    paths.push_back(fs::path(output).replace_extension(".labels.csv"));
  }
  return paths;
}

std::vector<text::File> files_of(const Exported& exported, const fs::path& output) {
  const std::vector<fs::path> paths = paths_of(output);
  std::vector<text::File> files{{paths.front(), format_of(output).write(exported)}};
  if (paths.size() > 1) files.push_back({paths.back(), labels_csv(exported)});
  return files;
}

}  // namespace piae::formats
