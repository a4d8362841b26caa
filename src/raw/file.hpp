#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "raw/signal.hpp"

namespace piae::raw {

/// Reads one signal of a raw recording. Its first bytes say its format (format.hpp):
///   MATLAB v5 and v7.3   `variable` is a real vector of any number type, which may stand inside
///                        others (variable_path.hpp)
///   HDF5                 `variable` is the path of a dataset of integers or floats
///   NumPy                `variable` is 1, or a row or column of a matrix (npy.hpp)
///   WAV, AIFF, FLAC      `variable` is a channel, counted from 1 (sound.hpp)
///   TDMS                 `variable` is a channel: "group/channel", or its number (tdms.hpp)
///   UFF 58               `variable` is a time record: its number, or its first ID line (uff.hpp)
///   LabVIEW (.lvm)       `variable` is a channel: its number, or its name (lvm.hpp)
///   text                 `variable` is a column: its number, counted from 1, or its name
/// Throws Error(bad_input) in one line with the file: what is wrong, and, where the variable is not
/// in the file, what the file has instead; also where the file says another sample rate than the
/// one given, or the variable holds a single number or none. NaN and infinite samples are returned
/// as they are.
///
/// The program `read_raw`, which stands beside the one that runs, reads it within the limits of
/// limits.hpp. A damaged file can make the libraries that read it crash, or take all memory: then
/// only that program ends, and the Error says how.
std::vector<double> read(const std::filesystem::path& file, const std::string& variable,
                         std::optional<double> sample_rate_hz = std::nullopt);

/// The same of several files, in their order, by one run of that program.
Signals read_all(const std::vector<std::filesystem::path>& files, const std::string& variable,
                 std::optional<double> sample_rate_hz = std::nullopt);

/// The same of one file in this process: what that program does.
Signal signal_here(const std::filesystem::path& file, const std::string& variable,
                   std::optional<double> sample_rate_hz = std::nullopt);
/// Its samples alone.
std::vector<double> read_here(const std::filesystem::path& file, const std::string& variable,
                              std::optional<double> sample_rate_hz = std::nullopt);

/// The formats one by one, in this process, whatever the extension.
std::vector<double> read_mat(const std::filesystem::path& file, const std::string& variable);
/// Fields are separated by semicolons, tabs, bars, commas or blanks, numbers have a decimal point
/// or, where commas do not separate, a decimal comma. Before them there may be comments, text and a
/// header (csv_layout.hpp); from there on every line has as many fields, of which there are 10 000
/// at most, and perhaps a separator at its end, and a number in the column. The text is UTF-8, or
/// UTF-16 with a byte order mark.
std::vector<double> read_csv(const std::filesystem::path& file, const std::string& column);
/// The same with the number of columns.
Signal read_table(const std::filesystem::path& file, const std::string& column);
/// A path of groups and a dataset; of a matrix with a row or column, "accel(2,:)", as h5dump counts
/// them but from 1. Soft links are followed within the file; nothing is read from elsewhere.
std::vector<double> read_hdf5(const std::filesystem::path& file, const std::string& dataset);
/// The same of a MATLAB file of version 7.3, which is one of HDF5, by variable_path.hpp.
std::vector<double> read_mat73(const std::filesystem::path& file, const std::string& variable);

/// The first of these names in one line, and how many more there are; "none" for none.
std::string listed(const std::vector<std::string>& names);

/// Throws Error(bad_input) with "<where>: <what>"; `where` begins with the file.
[[noreturn]] void refuse_file(const std::filesystem::path& where, const std::string& what);

}  // namespace piae::raw
