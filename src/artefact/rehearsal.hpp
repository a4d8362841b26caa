#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "artefact/reader.hpp"

namespace piae::artefact {

/// What a rehearsal found wrong: a reason and a line.
struct Objection {
  RefusalReason reason;
  std::string line;
};

/// Does in a child process what is about to be done with the bytes of a file, and returns what is
/// wrong with them; nothing when all is good. HDF5 trusts what it reads: a damaged or a made-up
/// file can end the process that opens it, write beyond its memory, or never end. All of that then
/// happens to the child, which has memory and time by the file's size and is killed beyond.
///
/// `read` throws Refusal for what it objects to. Whatever else becomes of the child is an objection
/// too, with the reason `damaged` and the line `otherwise`. The child is a copy of this process
/// with one thread, so `read` must start no other. Throws std::bad_alloc where the objection may be
/// that this process was given less memory than a good file of this size takes.
std::optional<Objection> rehearse(std::size_t size, const std::string& otherwise,
                                  const std::function<void()>& read);

/// The arguments of rehearse() for one file.
struct Rehearsal {
  std::size_t size;
  std::string otherwise;
  std::function<void()> read;
};

/// The same for each of many files. To start a child takes longer than to read a small file, so one
/// goes on to the next; where a file ends it, that one is rehearsed alone and another child goes on
/// behind it.
std::vector<std::optional<Objection>> rehearse_all(std::span<const Rehearsal> files);

}  // namespace piae::artefact
