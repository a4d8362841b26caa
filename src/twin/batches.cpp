#include "twin/batches.hpp"

#include <algorithm>
#include <map>

namespace piae::twin {

namespace {

using Indices = std::vector<std::size_t>;

std::vector<Indices> cut(const Indices& order, std::size_t size) {
  std::vector<Indices> batches;
  for (std::size_t i = 0; i < order.size(); i += size) {
    const auto from = order.begin() + static_cast<std::ptrdiff_t>(i);
    const std::size_t count = std::min(size, order.size() - i);
    batches.emplace_back(from, from + static_cast<std::ptrdiff_t>(count));
  }
  return batches;
}

/// Windows of one class; `is_whole` is true if they are all windows of the class.
struct Piece {
  Indices windows;
  bool is_whole = false;
};

std::vector<Piece> pieces_by_class(const std::vector<Label>& labels, const Indices& order,
                                   std::size_t size) {
  std::map<Label, Indices> by_class;
  for (const std::size_t i : order) by_class[labels[i]].push_back(i);
  std::vector<Piece> pieces;
  for (const auto& [_, own] : by_class) {
    for (Indices& windows : cut(own, size)) {
      pieces.push_back({std::move(windows), own.size() <= size});
    }
  }
  return pieces;
}

/// Joins the pieces in random order. Whole classes share a batch as long as they fit.
std::vector<Indices> joined(const std::vector<Piece>& pieces, std::size_t size, Stream& shuffle) {
  std::vector<Indices> batches;
  bool last_is_whole = false;
  for (const std::size_t i : shuffle.permutation(pieces.size())) {
    const Piece& piece = pieces[i];
    if (last_is_whole && piece.is_whole && batches.back().size() + piece.windows.size() <= size) {
      batches.back().insert(batches.back().end(), piece.windows.begin(), piece.windows.end());
    } else {
      batches.push_back(piece.windows);
    }
    last_is_whole = piece.is_whole;
  }
  return batches;
}

}  // namespace

std::vector<Indices> batches_of_an_epoch(const std::vector<Label>& labels, Batches kind,
                                         std::size_t size, Stream& shuffle) {
  const Indices order = shuffle.permutation(labels.size());
  if (kind == Batches::mixed) return cut(order, size);
  return joined(pieces_by_class(labels, order, size), size, shuffle);
}

}  // namespace piae::twin
