#include "twin/space.hpp"

#include <algorithm>
#include <string>

#include "signal/dataset_info.hpp"
#include "twin/ranges.hpp"

namespace piae::twin {

namespace {

const std::string labels_of_space = space_group + "/labels";

std::vector<double> equal_edges(double low, double high, int bins) {
  std::vector<double> edges;
  for (int i = 0; i <= bins; ++i) edges.push_back(low + (high - low) * i / bins);
  edges.back() = high;
  return edges;
}

std::vector<double> edges_over(const std::vector<TwinPoint>& points, double TwinPoint::*parameter,
                               int bins) {
  const auto [low, high] = std::ranges::minmax_element(
      points, {}, [&](const TwinPoint& point) { return point.*parameter; });
  return equal_edges((*low).*parameter, (*high).*parameter, bins);
}

std::vector<double> read_edges(const artefact::Reader& reader, const std::string& name) {
  const std::string path = space_group + "/" + name;
  std::vector<double> edges = reader.numbers<double>(path, {0}).values;
  reader.require_all(path, edges, ranges::coordinate);
  if (!ranges::bins.holds(static_cast<double>(edges.size()) - 1) ||
      !std::ranges::is_sorted(edges)) {
    reader.refuse(path, "must hold the edges of 1 to 1000 bins in ascending order");
  }
  return edges;
}

std::size_t bin_of(double value, const std::vector<double>& edges) {
  const auto above = std::upper_bound(edges.begin() + 1, edges.end() - 1, value);
  return static_cast<std::size_t>(above - edges.begin()) - 1;
}

}  // namespace

void write_points(artefact::Writer& writer, const std::string& name,
                  const std::vector<TwinPoint>& points) {
  std::vector<double> flat;
  for (const TwinPoint& point : points) flat.insert(flat.end(), {point.k, point.c});
  writer.numbers(name, flat, {points.size(), 2});
}

std::vector<TwinPoint> read_points(const artefact::Reader& reader, const std::string& name) {
  const auto flat = reader.numbers<double>(name, {0, 2}).values;
  reader.require_all(name, flat, ranges::coordinate);
  std::vector<TwinPoint> points;
  for (std::size_t i = 0; i < flat.size(); i += 2) points.push_back({flat[i], flat[i + 1]});
  return points;
}

TwinSpace::TwinSpace(const std::vector<TwinPoint>& points, int bins)
    : points_(points),
      k_edges_(edges_over(points, &TwinPoint::k, bins)),
      c_edges_(edges_over(points, &TwinPoint::c, bins)),
      counts_(static_cast<std::size_t>(bins) * static_cast<std::size_t>(bins)) {
  const std::size_t columns = c_edges_.size() - 1;
  for (const TwinPoint& point : points) {
    ++counts_[bin_of(point.k, k_edges_) * columns + bin_of(point.c, c_edges_)];
  }
}

TwinSpace::TwinSpace(const artefact::Reader& reader)
    : points_(read_points(reader, space_group + "/points")) {
  if (points_.empty()) reader.refuse(space_group + "/points", "is empty");
  k_edges_ = read_edges(reader, "k_edges");
  c_edges_ = read_edges(reader, "c_edges");
  counts_ = reader
                .numbers<std::int64_t>(space_group + "/counts",
                                       {k_edges_.size() - 1, c_edges_.size() - 1})
                .values;
  reader.require_all(space_group + "/counts", counts_, ranges::windows_in_a_bin);
  if (std::ranges::all_of(counts_, [](std::int64_t n) { return n == 0; })) {
    reader.refuse(space_group + "/counts", "is not a histogram");
  }
}

TwinPoint TwinSpace::sample(Stream& stream) const {
  std::size_t total = 0;
  for (const std::int64_t n : counts_) total += static_cast<std::size_t>(n);
  auto left = static_cast<std::int64_t>(stream.below(total));
  std::size_t bin = 0;
  while (left >= counts_[bin]) left -= counts_[bin++];
  const std::size_t row = bin / (c_edges_.size() - 1);
  const std::size_t column = bin % (c_edges_.size() - 1);
  const auto within = [&](double low, double high) {
    return low < high ? stream.uniform(low, high) : low;  // all known windows may be equal
  };
  const double k = within(k_edges_[row], k_edges_[row + 1]);
  return {k, within(c_edges_[column], c_edges_[column + 1])};
}

void TwinSpace::write(artefact::Writer& writer) const {
  write_points(writer, space_group + "/points", points_);
  writer.numbers(space_group + "/k_edges", k_edges_);
  writer.numbers(space_group + "/c_edges", c_edges_);
  writer.numbers(space_group + "/counts", counts_, {k_edges_.size() - 1, c_edges_.size() - 1});
}

TwinSpace space_of_class(const std::vector<TwinPoint>& points, const std::vector<Label>& labels,
                         Label label, int bins) {
  std::vector<TwinPoint> own;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (labels[i] == label) own.push_back(points[i]);
  }
  return {own, bins};
}

void require_points_of_faults(const artefact::Reader& model, const std::string& path,
                              const std::vector<Label>& labels) {
  const signal::DatasetInfo info = signal::read_dataset_info(model);
  for (const Label label : labels) {
    if (label < 0 || index_of(label) >= info.classes.size()) {
      model.refuse(path, "holds label " + std::to_string(label) + ", but no class has it");
    }
  }
  for (const Label fault : info.fault_labels()) {
    if (std::ranges::find(labels, fault) == labels.end()) {
      model.refuse(path, "has no known window of class " + info.class_of(fault).name);
    }
  }
}

void write_labels_of_space(artefact::Writer& writer, const std::vector<Label>& labels) {
  writer.numbers(labels_of_space, labels);
}

ClassSpaces::ClassSpaces(const artefact::Reader& model) : all_(model) {
  if (!model.has(labels_of_space)) return;
  labels_ = model.numbers<Label>(labels_of_space, {all_.points().size()}).values;
  require_points_of_faults(model, labels_of_space, labels_);
}

TwinSpace ClassSpaces::of(Label label) const {
  if (labels_.empty()) return all_;
  const auto bins = static_cast<int>(all_.k_edges().size() - 1);
  return space_of_class(all_.points(), labels_, label, bins);
}

}  // namespace piae::twin
