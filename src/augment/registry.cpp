#include <utility>

#include "augment/method.hpp"
#include "augment/piae_dt.hpp"
#include "base/error.hpp"

namespace piae::augment {

namespace {

using Factory = std::unique_ptr<Method> (*)();

template <class M>
std::unique_ptr<Method> make() {
  return std::make_unique<M>();
}

const std::pair<const char*, Factory> registry[] = {
    {"piae-dt", make<PiaeDt>},
};

}  // namespace

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const auto& [name, factory] : registry) names.emplace_back(name);
  return names;
}

std::unique_ptr<Method> make_method(const std::string& name) {
  std::string known;
  for (const auto& [each, factory] : registry) {
    if (name == each) return factory();
    known += std::string(known.empty() ? "" : ", ") + each;
  }
  throw Error(Exit::usage, name.empty()
                               ? "--method is missing; known are " + known
                               : "--method: unknown method '" + name + "'; known are " + known);
}

}  // namespace piae::augment
