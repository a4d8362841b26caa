#include "raw/format.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <string_view>

#include "raw/file.hpp"
#include "raw/lvm.hpp"
#include "raw/npy.hpp"
#include "raw/sound.hpp"
#include "raw/tdms.hpp"
#include "raw/text.hpp"
#include "raw/uff.hpp"

namespace piae::raw {

namespace {

namespace fs = std::filesystem;

/// Identifies a format by bytes at one place; `read` is null for a format that is not read.
struct Mark {
  std::string_view bytes;
  std::size_t at;
  Read read;
  const char* instead = "";  ///< format and how to convert it
};

/// Reads a format without a sample rate.
template <auto read_samples>
Signal unrated(const fs::path& file, const std::string& variable) {
  return {.samples = read_samples(file, variable)};
}

constexpr std::string_view hdf5_mark = "\x89HDF\r\n\x1a\n";
constexpr const char* other_sound =
    "is sound in an unsupported format; convert it: sox FILE OUT.wav";
constexpr const char* measurement_data_format =
    "is an MDF file (ASAM): export the channel as CSV (asammdf: MDF(FILE).export('csv'))";
constexpr const char* table_of_columns =
    "is a table in Parquet or Arrow: save it as CSV (pandas: read_parquet(FILE).to_csv(OUT))";
constexpr const char* pickled =
    "is a Python pickle: save the array with np.save('x.npy', a), or as CSV";
constexpr const char* marked_up =
    "is XML or HTML, not a table of numbers: export the samples as CSV";
constexpr const char* json = "is JSON: write the samples as CSV, one per row";

const std::array marks{
    Mark{"MATLAB 5.0 MAT-file", 0, unrated<read_mat>},
    Mark{"MATLAB 7.3 MAT-file", 0, unrated<read_mat>},
    Mark{hdf5_mark, 0, unrated<read_hdf5>},
    Mark{"\x93NUMPY", 0, unrated<read_npy>},
    Mark{"RIFF", 0, read_sound},
    Mark{"RF64", 0, read_sound},
    Mark{"AIFF", 8, read_sound},
    Mark{"AIFC", 8, read_sound},
    Mark{"fLaC", 0, read_sound},
    Mark{"riff\x2e\x91\xcf\x11", 0, read_sound},  // W64
    Mark{"LabVIEW Measurement", 0, read_lvm},
    Mark{"TDSm", 0, read_tdms},
    Mark{"TDSh", 0, nullptr, "is the index of a TDMS file: name the file that ends in .tdms"},
    Mark{"\x1f\x8b", 0, nullptr, "is compressed with gzip: unpack it (gunzip)"},
    Mark{"BZh", 0, nullptr, "is compressed with bzip2: unpack it (bunzip2)"},
    Mark{"\xfd"
         "7zXZ",
         0, nullptr, "is compressed with xz: unpack it (unxz)"},
    Mark{"7z\xbc\xaf", 0, nullptr, "is a 7z archive: unpack it"},
    Mark{"Rar!", 0, nullptr, "is a RAR archive: unpack it"},
    Mark{std::string_view("PK\x03\x04\x14\0\6\0", 8), 0, nullptr,
         "is an Excel workbook: save the sheet as CSV (File, Save as, CSV UTF-8)"},
    Mark{"mimetypeapplication/vnd.oasis.opendocument.spreadsheet", 30, nullptr,
         "is an OpenDocument spreadsheet: save the sheet as CSV (File, Save as, Text CSV)"},
    Mark{"PK\x03\x04", 0, nullptr,
         "is a zip archive (.zip, .npz) or an Excel workbook: unpack it (unzip), or save the sheet "
         "as CSV"},
    Mark{"\xd0\xcf\x11\xe0", 0, nullptr,
         "is an Excel workbook from before 2007: save the sheet as CSV (File, Save as, CSV)"},
    Mark{"version https://git-lfs", 0, nullptr,
         "is a Git LFS pointer, not the recording: fetch it (git lfs pull)"},
    Mark{"%PDF", 0, nullptr, "is a PDF document, not a recording"},
    Mark{".snd", 0, nullptr, other_sound},  // Sun's .au
    Mark{"caff", 0, nullptr, other_sound},
    Mark{"ID3", 0, nullptr, lossy_sound},
    Mark{"\xff\xfb", 0, nullptr, lossy_sound},  // MP3
    Mark{"\xff\xf3", 0, nullptr, lossy_sound},
    Mark{"\xff\xe3", 0, nullptr, lossy_sound},
    Mark{"\xff\xf1", 0, nullptr, lossy_sound},  // AAC
    Mark{"ftyp", 4, nullptr, lossy_sound},      // MP4, .m4a, .3gp
    Mark{"OggS", 0, nullptr, lossy_sound},
    Mark{"#!AMR", 0, nullptr, lossy_sound},
    Mark{"\x30\x26\xb2\x75", 0, nullptr, lossy_sound},  // WMA
    Mark{"MDF     ", 0, nullptr, measurement_data_format},
    Mark{"UnFinMF ", 0, nullptr, measurement_data_format},
    Mark{"PAR1", 0, nullptr, table_of_columns},
    Mark{"ARROW1", 0, nullptr, table_of_columns},
    Mark{"SQLite format 3", 0, nullptr, "is an SQLite database: export the samples as CSV"},
    Mark{"\x80\x03", 0, nullptr, pickled},
    Mark{"\x80\x04", 0, nullptr, pickled},
    Mark{"\x80\x05", 0, nullptr, pickled},
    Mark{"<?xml", 0, nullptr, marked_up},
    Mark{"<html", 0, nullptr, marked_up},
    Mark{"<!DOCTYPE", 0, nullptr, marked_up},
    Mark{"{\"", 0, nullptr, json},
    Mark{"[{", 0, nullptr, json},
};

/// Extensions of formats with a mark in their first bytes.
constexpr std::array marked_extensions{".mat", ".h5",   ".hdf5", ".npy",  ".wav", ".w64",
                                       ".aif", ".aiff", ".flac", ".tdms", ".uff", ".unv"};

/// Returns the extension in lower case, because loggers also write .CSV and .MAT.
std::string extension_of(const fs::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::string beginning_of(const fs::path& file) {
  std::string bytes(512, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

/// True if HDF5 follows a user block, which has 512, 1024, 2048, ... bytes.
bool has_user_block(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, hdf5_mark.size()> mark{};
  for (std::streamoff at = 512; in.seekg(at).read(mark.data(), mark.size()); at *= 2) {
    if (std::string_view(mark.data(), mark.size()) == hdf5_mark) return true;
  }
  return false;
}

/// True for a MATLAB file of version 4: a matrix of numbers with a header of five 4-byte numbers:
/// type, rows, columns, imaginary or not, length of the name.
bool is_mat4(std::string_view bytes) {
  if (bytes.size() < 20) return false;
  const auto number = [&](std::size_t i) {
    return static_cast<unsigned char>(bytes[4 * i]) |
           static_cast<unsigned char>(bytes[4 * i + 1]) << 8 |
           static_cast<unsigned char>(bytes[4 * i + 2]) << 16;
  };
  return bytes[3] == '\0' && number(0) < 5000 && number(3) < 2 && number(4) > 0 && number(4) < 64 &&
         number(1) > 0 && number(2) > 0 && bytes.find('\0') != std::string_view::npos;
}

/// True if FLAC follows an ID3 tag, whose length stands in 7 bits of each of four bytes.
bool is_tagged_flac(const fs::path& file, std::string_view bytes) {
  constexpr std::size_t head = 10;
  if (!bytes.starts_with("ID3") || bytes.size() < head) return false;
  std::streamoff length = head;
  for (std::size_t i = 0; i < 4; ++i) {
    length += static_cast<std::streamoff>(bytes[6 + i] & 0x7F) << (7 * (3 - i));
  }
  std::ifstream in(file, std::ios::binary);
  std::array<char, 4> mark{};
  in.seekg(length).read(mark.data(), mark.size());
  return in.good() && std::string_view(mark.data(), mark.size()) == "fLaC";
}

/// True for characters that text has, and no others: MATLAB's save -ascii and Octave's save write
/// text into .mat files.
bool is_text(std::string_view bytes) {
  const auto is_of_text = [](char c) { return (c >= '\t' && c <= '\r') || (c >= ' ' && c < 127); };
  return !bytes.empty() && std::ranges::all_of(bytes, is_of_text);
}

}  // namespace

Read reader_of(const fs::path& file) {
  const std::string bytes = without_byte_order_mark(beginning_of(file));
  if (is_tagged_flac(file, bytes)) {
    refuse_file(file, "is FLAC behind an ID3 tag; remove the tag: id3v2 --delete-all FILE");
  }
  for (const Mark& mark : marks) {
    if (bytes.size() < mark.at ||
        !std::string_view(bytes).substr(mark.at).starts_with(mark.bytes)) {
      continue;
    }
    if (mark.read == nullptr) refuse_file(file, mark.instead);
    return mark.read;
  }
  if (has_user_block(file)) return unrated<read_hdf5>;
  if (is_uff(bytes)) return read_uff;
  const std::string extension = extension_of(file);
  if (std::ranges::count(marked_extensions, extension) == 0) return read_table;
  if (extension != ".mat") {
    refuse_file(file,
                "truncated, damaged or not a '" + extension + "' file: it does not begin like one");
  }
  if (is_text(bytes)) return read_table;
  if (is_mat4(bytes)) {
    refuse_file(
        file,
        "is a MATLAB file of version 4: save it as version 5 (save -v7 FILE, or savemat of SciPy)");
  }
  return unrated<read_mat>;  // read_mat reports what is wrong
}

}  // namespace piae::raw
