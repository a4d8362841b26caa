#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "raw/signal.hpp"

namespace piae::raw {

/// Reads one signal of a raw recording. The first bytes of the file determine its format
/// (format.hpp):
///   MATLAB v5 and v7.3   `variable` is a real vector of any number type, possibly inside others
///                        (variable_path.hpp)
///   HDF5                 `variable` is the path of a dataset of integers or floats
///   NumPy                `variable` is 1, or a row or column of a matrix (npy.hpp)
///   WAV, AIFF, FLAC      `variable` is a channel, counted from 1 (sound.hpp)
///   TDMS                 `variable` is a channel: "group/channel", or its number (tdms.hpp)
///   UFF 58               `variable` is a time record: its number, or its first ID line (uff.hpp)
///   LabVIEW (.lvm)       `variable` is a channel: its number, or its name (lvm.hpp)
///   text                 `variable` is a column: its number, counted from 1, or its name
/// Returns NaN and infinite samples unchanged. Throws Error(bad_input) in one line with the file
/// and what is wrong. Lists what the file has if the variable is missing. Also throws if the file
/// declares another sample rate than the given one, or if the variable holds fewer than two
/// numbers.
///
/// Runs the program `read_raw` next to the current program, within the limits of limits.hpp. A
/// damaged file may crash a library or take all memory. Then only read_raw ends, and the Error
/// reports why.
std::vector<double> read(const std::filesystem::path& file, const std::string& variable,
                         std::optional<double> sample_rate_hz = std::nullopt);

/// Reads one signal of each file, in their order, in one run of read_raw.
Signals read_all(const std::vector<std::filesystem::path>& files, const std::string& variable,
                 std::optional<double> sample_rate_hz = std::nullopt);

/// Reads one signal in this process, as read_raw does.
Signal signal_here(const std::filesystem::path& file, const std::string& variable,
                   std::optional<double> sample_rate_hz = std::nullopt);
/// Returns only the samples of signal_here().
std::vector<double> read_here(const std::filesystem::path& file, const std::string& variable,
                              std::optional<double> sample_rate_hz = std::nullopt);

/// Reads a MATLAB file in this process, whatever its extension.
std::vector<double> read_mat(const std::filesystem::path& file, const std::string& variable);
/// Reads a column of a text in UTF-8, or in UTF-16 with a byte order mark. Fields are separated by
/// semicolons, tabs, bars, commas or blanks. Numbers have a decimal point or, if commas are not the
/// separators, a decimal comma. Comments, text and a header may come first (csv_layout.hpp). All
/// later lines have a number in the column and the same number of fields, at most 10,000. They may
/// end with a separator.
std::vector<double> read_csv(const std::filesystem::path& file, const std::string& column);
/// Reads a column like read_csv(), with the number of columns and the times.
Signal read_table(const std::filesystem::path& file, const std::string& column);
/// Reads a dataset by its path, or a row or column of a matrix: "accel(2,:)", dimensions in the
/// order of h5dump, but counted from 1. Follows soft links within the file; reads no other file.
std::vector<double> read_hdf5(const std::filesystem::path& file, const std::string& dataset);
/// Reads a variable (variable_path.hpp) of a MATLAB file of version 7.3, which is an HDF5 file.
std::vector<double> read_mat73(const std::filesystem::path& file, const std::string& variable);

/// Returns the first names in one line and the number of the others; "none" if there are none.
std::string listed(const std::vector<std::string>& names);

/// Throws Error(bad_input) with "<where>: <what>"; `where` starts with the file.
[[noreturn]] void refuse_file(const std::filesystem::path& where, const std::string& what);

}  // namespace piae::raw
