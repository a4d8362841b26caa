#include "storm/meaning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "stages/doctor.hpp"

namespace piae::storm {

namespace {

namespace hdf5 = artefact::hdf5;
using hdf5::check;
using hdf5::Handle;
using hdf5::Shape;

constexpr std::array<std::int64_t, 22> whole{0,
                                             -1,
                                             1,
                                             2,
                                             3,
                                             5,
                                             7,
                                             100,
                                             255,
                                             1000,
                                             65536,
                                             1 << 20,
                                             1 << 24,
                                             2147483647,
                                             2147483648,
                                             -2147483648LL,
                                             std::int64_t{1} << 40,
                                             std::int64_t{1} << 53,
                                             std::int64_t{1} << 61,
                                             std::int64_t{1} << 62,
                                             std::numeric_limits<std::int64_t>::max(),
                                             std::numeric_limits<std::int64_t>::min()};

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<double, 26> real{
    0,    -0.0, -1,     1,     0.5,    0.999999, 2,   1e-9, -1e-9, 1e-320,   1e9,  1e12, 1e15,
    1e18, 1e38, 3.5e38, 1e300, -1e300, 1e308,    nan, inf,  -inf,  4.9e-324, 1e-3, 1e6,  -1e6};

const std::array<std::string, 30> text{"",
                                       " ",
                                       ".",
                                       "..",
                                       "/",
                                       "a/b",
                                       "../../x",
                                       "a\nb",
                                       "\x1b[2J",
                                       "-x",
                                       "$(x)",
                                       "`x`",
                                       "%s%n",
                                       "\xff\xfe",
                                       "nan",
                                       "Normal",
                                       "IR007",
                                       "none",
                                       "piae-dt",
                                       "smote",
                                       "vae",
                                       "oracle",
                                       "E",
                                       "A",
                                       "records",
                                       "model",
                                       "windows",
                                       "best",
                                       std::string(300, 'x'),
                                       std::string(60000, 'y')};

/// An artefact that is open for changes, and its contents.
struct Patient {
  hid_t file = -1;
  std::vector<std::string> objects;  ///< including the root
  std::vector<std::string> datasets;
};

bool is_dataset(hid_t file, const std::string& path) {
  const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), path.c_str());
  return H5Iget_type(object) == H5I_DATASET;
}

Patient patient_of(hid_t file) {
  Patient patient{file, hdf5::object_paths(file), {}};
  for (const std::string& path : patient.objects) {
    if (is_dataset(file, path)) patient.datasets.push_back(path);
  }
  patient.objects.insert(patient.objects.begin(), "/");
  return patient;
}

// ---- types and bytes ----------------------------------------------------------------------------

Handle string_type(std::size_t length) {
  Handle type(H5Tcopy(H5T_C_S1), "string type");
  check(H5Tset_size(type, length), "string type");
  check(H5Tset_strpad(type, H5T_STR_NULLPAD), "string type");
  check(H5Tset_cset(type, H5T_CSET_UTF8), "string type");
  return type;
}

/// A value that may cause an error, with its type.
struct Value {
  Handle type;
  std::string bytes;
  std::string words;
};

template <class T>
Value number(hid_t type, T number) {
  Value value{Handle(H5Tcopy(type), "type"), std::string(sizeof number, '\0'), {}};
  std::memcpy(value.bytes.data(), &number, sizeof number);
  std::ostringstream words;
  words << number;
  value.words = words.str();
  return value;
}

Value string_value(const std::string& string) {
  std::string padded = string.empty() ? std::string(1, '\0') : string;
  Handle type = string_type(padded.size());
  return {std::move(type), std::move(padded), "'" + string.substr(0, 20) + "'"};
}

Value value_of_class(H5T_class_t kind, std::size_t size, Dice& dice) {
  if (kind == H5T_STRING) return string_value(dice.one_of(text));
  if (kind == H5T_INTEGER && size == 4) {
    return number(H5T_STD_I32LE, static_cast<std::int32_t>(dice.one_of(whole)));
  }
  if (kind == H5T_INTEGER) return number(H5T_STD_I64LE, dice.one_of(whole));
  if (size == 4) return number(H5T_IEEE_F32LE, static_cast<float>(dice.one_of(real)));
  return number(H5T_IEEE_F64LE, dice.one_of(real));
}

Value value_of_any_class(Dice& dice) {
  static constexpr std::array<H5T_class_t, 3> kinds{H5T_STRING, H5T_INTEGER, H5T_FLOAT};
  return value_of_class(dice.one_of(kinds), dice.one_in(2) ? 4 : 8, dice);
}

std::string repeated(const std::string& bytes, std::size_t times) {
  std::string all;
  all.reserve(bytes.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += bytes;
  return all;
}

Handle space_of(const std::vector<hsize_t>& extents) {
  return {H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), "space"};
}

// ---- attributes ---------------------------------------------------------------------------------

void write_attribute(hid_t file, const std::string& path, const std::string& name,
                     const Value& value, hid_t space, std::size_t count) {
  const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), path.c_str());
  if (H5Aexists(object, name.c_str()) > 0) check(H5Adelete(object, name.c_str()), name.c_str());
  const Handle attribute(
      H5Acreate2(object, name.c_str(), value.type, space, H5P_DEFAULT, H5P_DEFAULT), name.c_str());
  if (count == 0) return;
  check(H5Awrite(attribute, value.type, repeated(value.bytes, count).data()), name.c_str());
}

std::string change_attribute(const Patient& patient, Dice& dice) {
  const std::string& path = dice.one_of(patient.objects);
  const Handle object(H5Oopen(patient.file, path.c_str(), H5P_DEFAULT), path.c_str());
  const std::vector<std::string> names = hdf5::attribute_names(object);
  const Handle scalar(H5Screate(H5S_SCALAR), "space");
  if (names.empty()) {
    write_attribute(patient.file, path, "more", value_of_any_class(dice), scalar, 1);
    return path + ": an attribute more";
  }
  const std::string& name = dice.one_of(names);
  const std::string where = path + "@" + name + ": ";
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), name.c_str());
  const Handle type(H5Aget_type(attribute), name.c_str());
  Value same = value_of_class(H5Tget_class(type), H5Tget_size(type), dice);
  switch (dice.below(10)) {
    case 0: {
      const Value other = value_of_any_class(dice);
      write_attribute(patient.file, path, name, other, scalar, 1);
      return where + "of another type, " + other.words;
    }
    case 1: {
      static constexpr std::array<hsize_t, 4> counts{1, 2, 100, 8000};
      const hsize_t count = same.bytes.size() > 64 ? 1 : dice.one_of(counts);
      write_attribute(patient.file, path, name, same, space_of({count}), count);
      return where + "an array of " + std::to_string(count) + ' ' + same.words;
    }
    case 2: {
      const Handle null(H5Screate(H5S_NULL), "space");
      write_attribute(patient.file, path, name, same, null, 0);
      return where + "without a value";
    }
    case 3:
      check(H5Adelete(object, name.c_str()), name.c_str());
      return where + "removed";
    case 4:
      check(H5Arename(object, name.c_str(), (name + "2").c_str()), name.c_str());
      return where + "renamed";
    default:
      write_attribute(patient.file, path, name, same, scalar, 1);
      return where + same.words;
  }
}

// ---- datasets -----------------------------------------------------------------------------------

struct Content {
  Shape shape;
  Handle type;
  std::string bytes;
};

/// True if a dataset declares more bytes than any artefact of the storm has, as it may after a
/// first change.
bool claims_too_much(hid_t dataset) {
  constexpr double most_bytes = 1 << 28;
  const Handle type(H5Dget_type(dataset), "type");
  const Handle space(H5Dget_space(dataset), "space");
  return static_cast<double>(H5Sget_simple_extent_npoints(space)) *
             static_cast<double>(H5Tget_size(type)) >
         most_bytes;
}

Content content_of(const Patient& patient, const std::string& path) {
  const Handle dataset = hdf5::open_dataset(patient.file, path);
  if (claims_too_much(dataset)) throw std::runtime_error(path + " claims too much to be read");
  Content content{hdf5::shape_of(dataset), Handle(H5Dget_type(dataset), path.c_str()), {}};
  std::size_t count = 1;
  for (const std::size_t extent : content.shape) count *= extent;
  content.bytes.resize(count * H5Tget_size(content.type));
  if (count > 0) {
    check(H5Dread(dataset, content.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, content.bytes.data()),
          path.c_str());
  }
  return content;
}

/// Replaces a dataset by another, and copies its attributes.
void replace_dataset(const Patient& patient, const std::string& path, hid_t type, hid_t space,
                     hid_t creation, const std::string& bytes) {
  const std::string old = path + "-old";
  check(H5Lmove(patient.file, path.c_str(), patient.file, old.c_str(), H5P_DEFAULT, H5P_DEFAULT),
        path.c_str());
  const Handle before = hdf5::open_dataset(patient.file, old);
  const Handle dataset(
      H5Dcreate2(patient.file, path.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
      path.c_str());
  if (!bytes.empty()) {
    check(H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()), path.c_str());
  }
  for (const std::string& name : hdf5::attribute_names(before)) {
    const Handle from(H5Aopen(before, name.c_str(), H5P_DEFAULT), name.c_str());
    const Handle kind(H5Aget_type(from), name.c_str());
    const Handle extent(H5Aget_space(from), name.c_str());
    std::string value(H5Tget_size(kind) * static_cast<std::size_t>(std::max<hssize_t>(
                                              H5Sget_simple_extent_npoints(extent), 1)),
                      '\0');
    check(H5Aread(from, kind, value.data()), name.c_str());
    const Handle to(H5Acreate2(dataset, name.c_str(), kind, extent, H5P_DEFAULT, H5P_DEFAULT),
                    name.c_str());
    check(H5Awrite(to, kind, value.data()), name.c_str());
  }
  check(H5Ldelete(patient.file, old.c_str(), H5P_DEFAULT), old.c_str());
}

std::string resized(std::string bytes, std::size_t size) {
  if (bytes.empty()) return std::string(size, '\0');
  while (bytes.size() < size) bytes += bytes.substr(0, size - bytes.size());
  bytes.resize(size);
  return bytes;
}

void write_shape(const Patient& patient, const std::string& path, const Content& content,
                 const std::vector<hsize_t>& extents, hid_t creation) {
  hsize_t count = 1;
  for (const hsize_t extent : extents) count *= extent;
  const std::size_t size = count * H5Tget_size(content.type);
  replace_dataset(patient, path, content.type, space_of(extents), creation,
                  count == 0 ? "" : resized(content.bytes, size));
}

std::string in_words(const std::vector<hsize_t>& extents) {
  std::string words;
  for (const hsize_t extent : extents) words += (words.empty() ? "" : "x") + std::to_string(extent);
  return words;
}

/// Returns the product's layout: one chunk with a checksum for numbers, contiguous for strings.
Handle usual_layout(const std::vector<hsize_t>& extents, const Content& content) {
  Handle creation(H5Pcreate(H5P_DATASET_CREATE), "layout");
  if (H5Tget_class(content.type) == H5T_STRING || extents.empty()) return creation;
  std::vector<hsize_t> chunk = extents;
  for (hsize_t& extent : chunk) extent = std::max<hsize_t>(extent, 1);
  check(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), "layout");
  check(H5Pset_fletcher32(creation), "layout");
  return creation;
}

std::string change_shape(const Patient& patient, const std::string& path, Dice& dice) {
  const Content content = content_of(patient, path);
  std::vector<hsize_t> extents(content.shape.begin(), content.shape.end());
  const std::size_t axis = extents.empty() ? 0 : dice.below(extents.size());
  switch (extents.empty() ? 5 : dice.below(7)) {
    case 0:
      extents[axis] = 0;
      break;
    case 1:
      extents[axis] = 1;
      break;
    case 2:
      extents[axis] += 1;
      break;
    case 3:
      extents[axis] -= std::min<hsize_t>(extents[axis], 1);
      break;
    case 4:
      std::ranges::reverse(extents);
      break;
    case 5:
      extents.push_back(1);
      break;
    default:
      extents.pop_back();
  }
  write_shape(patient, path, content, extents, usual_layout(extents, content));
  return path + ": has the shape " + in_words(extents);
}

std::string change_type(const Patient& patient, const std::string& path, Dice& dice) {
  const Content content = content_of(patient, path);
  const std::array<hid_t, 8> types{H5T_IEEE_F32LE, H5T_IEEE_F64LE, H5T_STD_I32LE, H5T_STD_I64LE,
                                   H5T_STD_U8LE,   H5T_IEEE_F64BE, H5T_STD_U64LE, H5T_STD_I8LE};
  Content changed{content.shape, Handle(H5Tcopy(dice.one_of(types)), "type"), {}};
  std::size_t count = 1;
  for (const std::size_t extent : content.shape) count *= extent;
  changed.bytes = resized(content.bytes, count * H5Tget_size(changed.type));
  const std::vector<hsize_t> extents(content.shape.begin(), content.shape.end());
  const Handle creation = usual_layout(extents, changed);
  replace_dataset(patient, path, changed.type, space_of(extents), creation, changed.bytes);
  return path + ": of another type";
}

/// Gives a dataset another layout: compressed, compact, in another file, or larger than its values.
std::string change_layout(const Patient& patient, const std::string& path, Dice& dice) {
  const Content content = content_of(patient, path);
  std::vector<hsize_t> extents(content.shape.begin(), content.shape.end());
  if (extents.empty() || std::ranges::find(extents, hsize_t{0}) != extents.end()) {
    return change_shape(patient, path, dice);
  }
  const Handle creation(H5Pcreate(H5P_DATASET_CREATE), "layout");
  switch (dice.below(6)) {
    case 0:
      check(H5Pset_chunk(creation, static_cast<int>(extents.size()), extents.data()), "layout");
      check(H5Pset_deflate(creation, 9), "layout");
      write_shape(patient, path, content, extents, creation);
      return path + ": compressed";
    case 1: {
      const std::vector<hsize_t> chunk(extents.size(), 1);
      check(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()), "layout");
      extents[0] = hsize_t{1} << (20 + dice.below(42));
      replace_dataset(patient, path, content.type, space_of(extents), creation, "");
      return path + ": claims " + in_words(extents) + " values and holds none";
    }
    case 2:
      check(H5Pset_external(creation, "/etc/hostname", 0, H5F_UNLIMITED), "layout");
      replace_dataset(patient, path, content.type, space_of(extents), creation, "");
      return path + ": its values lie in another file";
    case 3: {
      check(H5Pset_layout(creation, H5D_VIRTUAL), "layout");
      const Handle space = space_of(extents);
      check(H5Pset_virtual(creation, space, "A.h5", "/windows", space), "layout");
      replace_dataset(patient, path, content.type, space, creation, "");
      return path + ": virtual";
    }
    case 4:
      check(H5Pset_layout(creation, content.bytes.size() < 60000 ? H5D_COMPACT : H5D_CONTIGUOUS),
            "layout");
      write_shape(patient, path, content, extents, creation);
      return path + ": compact";
    default: {
      extents[0] = hsize_t{1} << (20 + dice.below(38));
      replace_dataset(patient, path, content.type, space_of(extents), creation, "");
      return path + ": claims " + in_words(extents) + " values in a row and holds none";
    }
  }
}

std::string change_values(const Patient& patient, const std::string& path, Dice& dice) {
  Content content = content_of(patient, path);
  const std::size_t size = H5Tget_size(content.type);
  const std::size_t count = content.bytes.size() / size;
  if (count == 0) return change_shape(patient, path, dice);
  Value value = value_of_class(H5Tget_class(content.type), size, dice);
  value.bytes.resize(size);
  const std::size_t first = dice.below(count);
  const bool all = dice.one_in(4);
  for (std::size_t i = 0; i < count; ++i) {
    if (all || i == first) content.bytes.replace(i * size, size, value.bytes);
  }
  const Handle dataset = hdf5::open_dataset(patient.file, path);
  check(H5Dwrite(dataset, content.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, content.bytes.data()),
        path.c_str());
  return path + (all ? ": all values are " : "[" + std::to_string(first) + "]: ") + value.words;
}

/// Copies one value of a dataset over another: each value is possible, but the combination may not
/// be.
std::string change_order(const Patient& patient, const std::string& path, Dice& dice) {
  Content content = content_of(patient, path);
  const std::size_t size = H5Tget_size(content.type);
  const std::size_t count = content.bytes.size() / size;
  if (count < 2) return change_shape(patient, path, dice);
  const std::size_t from = dice.below(count);
  const std::size_t to = dice.below(count);
  content.bytes.replace(to * size, size, content.bytes.substr(from * size, size));
  const Handle dataset = hdf5::open_dataset(patient.file, path);
  check(H5Dwrite(dataset, content.type, H5S_ALL, H5S_ALL, H5P_DEFAULT, content.bytes.data()),
        path.c_str());
  return path + ": value " + std::to_string(to) + " is that of " + std::to_string(from);
}

std::string change_dataset(const Patient& patient, Dice& dice) {
  const std::string& path = dice.one_of(patient.datasets);
  switch (dice.below(8)) {
    case 0:
    case 1:
      return change_shape(patient, path, dice);
    case 2:
      return change_type(patient, path, dice);
    case 3:
      return change_layout(patient, path, dice);
    case 4:
      return change_order(patient, path, dice);
    default:
      return change_values(patient, path, dice);
  }
}

// ---- links --------------------------------------------------------------------------------------

std::string nest(hid_t file, std::size_t depth) {
  Handle group(H5Gopen2(file, "/", H5P_DEFAULT), "/");
  for (std::size_t i = 0; i < depth; ++i) {
    group = Handle(H5Gcreate2(group, "deep", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "deep");
  }
  return std::to_string(depth) + " groups in each other";
}

std::string change_link(const Patient& patient, const std::vector<std::filesystem::path>& others,
                        Dice& dice) {
  const std::string& path = patient.objects[dice.below(patient.objects.size() - 1) + 1];
  const std::string in_place = dice.one_in(2) ? path : "/more";
  const auto make_room = [&] {
    if (in_place == path) check(H5Ldelete(patient.file, path.c_str(), H5P_DEFAULT), "link");
  };
  switch (dice.below(9)) {
    case 0:
      check(H5Ldelete(patient.file, path.c_str(), H5P_DEFAULT), path.c_str());
      return path + ": removed";
    case 1:
      check(H5Lmove(patient.file, path.c_str(), patient.file, (path + "2").c_str(), H5P_DEFAULT,
                    H5P_DEFAULT),
            path.c_str());
      return path + ": renamed";
    case 2:
      make_room();
      check(H5Lcreate_soft(dice.one_of(patient.objects).c_str(), patient.file, in_place.c_str(),
                           H5P_DEFAULT, H5P_DEFAULT),
            "soft link");
      return in_place + ": a soft link";
    case 3:
      make_room();
      check(H5Lcreate_external(dice.one_of(others).c_str(), path.c_str(), patient.file,
                               in_place.c_str(), H5P_DEFAULT, H5P_DEFAULT),
            "external link");
      return in_place + ": an external link";
    case 4:
      check(H5Lcreate_hard(patient.file, dice.one_of(patient.objects).c_str(), patient.file,
                           "/more", H5P_DEFAULT, H5P_DEFAULT),
            "hard link");
      return "/more: a second hard link";
    case 5: {
      const Handle type = string_type(4);
      check(H5Tcommit2(patient.file, "/more", type, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), "type");
      return "/more: a type with a name";
    }
    case 6:
      return nest(patient.file, 1 + dice.below(300));
    case 7: {
      const Handle group(H5Gcreate2(patient.file, "/more", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         "group");
      return "/more: a group";
    }
    default: {
      const Handle other(H5Fopen(dice.one_of(others).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), "open");
      if (H5Lexists(other, path.c_str(), H5P_DEFAULT) <= 0) return nest(patient.file, 1);
      check(H5Ldelete(patient.file, path.c_str(), H5P_DEFAULT), path.c_str());
      check(H5Ocopy(other, path.c_str(), patient.file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT),
            path.c_str());
      return path + ": that of another artefact";
    }
  }
}

// ---- sizes --------------------------------------------------------------------------------------

/// Sets the number of classes; new classes copy the last one.
void change_classes(const Patient& patient, std::size_t count) {
  std::vector<std::string> names = hdf5::read_strings(patient.file, "/classes/name");
  std::vector<std::string> defects = hdf5::read_strings(patient.file, "/classes/defect");
  // An earlier change may have left no class to copy.
  if (names.empty() || defects.empty()) return;
  const std::size_t before = names.size();
  while (names.size() < count) names.push_back("class" + std::to_string(names.size()));
  defects.resize(count, defects.back());
  names.resize(count);
  stages::replace_strings(patient.file, "/classes/name", names);
  stages::replace_strings(patient.file, "/classes/defect", defects);
  for (const char* path : {"/classes/defect_size_mm", "/classes/rms"}) {
    if (H5Lexists(patient.file, path, H5P_DEFAULT) <= 0) continue;
    Content content = content_of(patient, path);
    const std::size_t size = content.bytes.size() / before;
    while (content.bytes.size() < count * size) {
      content.bytes += content.bytes.substr(content.bytes.size() - size);
    }
    write_shape(patient, path, content, {count}, usual_layout({count}, content));
  }
}

/// Sets numbers that are possible one by one, but may exceed all limits together.
std::string change_sizes(const Patient& patient, Dice& dice) {
  static constexpr std::array<double, 4> rates{1, 1000, 12000, 1e7};
  static constexpr std::array<std::int64_t, 3> all_balls{9, 100, 1000};
  static constexpr std::array<std::int64_t, 4> lengths{1, 100, 1024, 1 << 20};
  static constexpr std::array<std::size_t, 4> classes{3, 100, 1000, 20000};
  const double rate = dice.one_of(rates);
  const std::int64_t balls = dice.one_of(all_balls);
  const std::int64_t length = dice.one_of(lengths);
  const std::size_t count = dice.one_of(classes);
  stages::replace_attribute(patient.file, "/", "sample_rate_hz", rate);
  stages::change_balls(patient.file, balls);
  change_classes(patient, count);
  const bool has_length = H5Aexists_by_name(patient.file, "/", "samples", H5P_DEFAULT) > 0;
  if (has_length) stages::replace_attribute(patient.file, "/", "samples", length);
  std::ostringstream words;
  words << rate << " Hz, " << balls << " balls, " << count << " classes, " << length << " samples";
  return words.str();
}

bool one_claims_too_much(hid_t file) {
  return std::ranges::any_of(hdf5::object_paths(file), [&](const std::string& path) {
    const Handle object(H5Oopen(file, path.c_str(), H5P_DEFAULT), path.c_str());
    return H5Iget_type(object) == H5I_DATASET && claims_too_much(object);
  });
}

/// Renews the digests, unless a dataset declares so much that reading it would end this process: no
/// reader may reach such a digest.
void renew_digests(hid_t file) {
  try {
    if (one_claims_too_much(file)) return;
    const artefact::Digests digests = artefact::digests_of(file, hdf5::object_paths(file));
    stages::replace_attribute(file, artefact::provenance_group, artefact::digest_attribute,
                              digests.provenance);
    stages::replace_attribute(file, "/", artefact::digest_attribute, digests.content);
  } catch (const std::exception&) {
    // If the product's own digest refuses the file, its readers must refuse it, too.
  }
}

}  // namespace

std::string change_meaning(const std::filesystem::path& file,
                           const std::vector<std::filesystem::path>& others, Dice& dice) {
  const Handle open(H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), "open");
  const Patient patient = patient_of(open);
  std::string changes;
  const std::size_t count = dice.one_in(5) ? 2 : 1;
  for (std::size_t i = 0; i < count; ++i) {
    try {
      const std::size_t what = dice.below(9);
      changes += (changes.empty() ? "" : "; ") + (what < 3   ? change_attribute(patient, dice)
                                                  : what < 6 ? change_dataset(patient, dice)
                                                  : what < 7 ? change_sizes(patient, dice)
                                                             : change_link(patient, others, dice));
    } catch (const std::exception& error) {
      // A second change may need what the first one removed, and HDF5 may refuse a change.
      changes += (changes.empty() ? "" : "; ") + std::string("could not: ") + error.what();
    }
  }
  renew_digests(open);
  return changes;
}

}  // namespace piae::storm
