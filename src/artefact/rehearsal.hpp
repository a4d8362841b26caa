#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"

namespace piae::artefact {

/// Objection of a rehearsal to a file: a reason and an error line.
struct Objection {
  RefusalReason reason;
  std::string line;
};

/// Runs `read` on the bytes of a file in a child process first, and returns its objection; empty if
/// the file is good. HDF5 trusts what it reads: a damaged or forged file can crash the process,
/// write out of bounds, or never end. Then only the child is harmed: it has limits of memory and
/// time by the size of the file, and is killed beyond them.
///
/// `read` throws Refusal for its objections. Any other end of the child is an objection with the
/// reason `damaged` and the line `otherwise`. The child is a copy of this process with one thread,
/// so `read` must not start threads. Throws std::bad_alloc if the objection may only mean that this
/// process has less memory than a good file of this size needs.
std::optional<Objection> rehearse(std::size_t size, const std::string& otherwise,
                                  const std::function<void()>& read);

/// Arguments of rehearse() for one file.
struct Rehearsal {
  std::size_t size;
  std::string otherwise;
  std::function<void()> read;
};

/// Rehearses many files. Starting a child takes longer than reading a small file, so one child
/// reads them in turn. A file that ends the child is rehearsed again alone, and another child
/// continues after it.
std::vector<std::optional<Objection>> rehearse_all(std::span<const Rehearsal> files);

}  // namespace piae::artefact
