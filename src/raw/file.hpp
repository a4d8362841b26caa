#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace piae::signal {

/// Reads one signal of a raw recording. The extension of the file, in capitals or not, says its
/// format:
///   .mat         MATLAB v5 and v7.3, by libmatio; `variable` is a real vector of any number type
///   .csv, .txt   `variable` is a column: its number, counted from 1, or its name in the header
///   .h5, .hdf5   `variable` is the path of a one-dimensional dataset of integers or floats
/// Throws Error(bad_input) in one line with the file: what is wrong, and, where the variable is not
/// in the file, what the file has instead. NaN and infinite samples are returned as they are.
///
/// The program `read_raw`, which stands beside the one that runs, reads it within the limits of
/// raw_limits.hpp. A damaged file can make the libraries that read it crash, or take all memory:
/// then only that program ends, and the Error says how.
std::vector<double> read_raw_file(const std::filesystem::path& file, const std::string& variable);

/// The same in this process: what that program does.
std::vector<double> read_here(const std::filesystem::path& file, const std::string& variable);

/// The formats one by one, in this process, whatever the extension.
std::vector<double> read_mat(const std::filesystem::path& file, const std::string& variable);
/// Fields are separated by semicolons, tabs, commas or blanks, numbers have a decimal point or,
/// where commas do not separate, a decimal comma. Before them there may be comments, text and a
/// header (csv_layout.hpp); from there on every line has as many fields, of which there are 10 000
/// at most, and a number in the column. The text is UTF-8, or UTF-16 with a byte order mark.
std::vector<double> read_csv(const std::filesystem::path& file, const std::string& column);
/// Nothing is read from elsewhere: no link is followed, and no dataset is taken whose values stand
/// in another file.
std::vector<double> read_hdf5(const std::filesystem::path& file, const std::string& dataset);

/// Throws as read_hdf5() would for a variable of a MATLAB file of version 7.3, which is a dataset
/// of an HDF5 file, without reading it. A group will do, and so will a name that is not there.
void require_own_vector(const std::filesystem::path& file, const std::string& variable);

/// The first of these names in one line, and how many more there are; "none" for none.
std::string listed(const std::vector<std::string>& names);

/// Throws Error(bad_input) with "<where>: <what>"; `where` begins with the file.
[[noreturn]] void refuse_raw_file(const std::filesystem::path& where, const std::string& what);

}  // namespace piae::signal
