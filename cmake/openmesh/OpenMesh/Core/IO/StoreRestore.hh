// Takes the place of OpenMesh's header of this name: properties of meshes are never written to streams here, but the
// virtual functions that would do so bring streams and all their locales into the WASM module, a fifteenth of it.
#ifndef FOLDWRIGHT_OPENMESH_STORE_RESTORE_HH
#define FOLDWRIGHT_OPENMESH_STORE_RESTORE_HH

#include <cstddef>
#include <iosfwd>
#include <map>  // OpenMesh counts on it
#include <numeric>
#include <string>
#include <vector>

#include <OpenMesh/Core/System/config.h>

namespace OpenMesh::IO {

enum : std::size_t { UnknownSize = static_cast<std::size_t>(-1) };

/// What OpenMesh knows of a value that can be stored; here of none.
template <class Value>
struct binary {
  static constexpr bool is_streamable = false;
  static std::string type_identifier() { return {}; }
};

template <class Value>
bool is_streamable() {
  return false;
}

template <class Value>
std::size_t size_of() {
  return UnknownSize;
}

template <class Value>
std::size_t size_of(const Value&) {
  return UnknownSize;
}

/// Stores nothing.
template <class Value>
std::size_t store(std::ostream&, const Value&, bool = false, bool = true) {
  return 0;
}

/// Restores nothing: takes the elements of a `std::vector<bool>` as well, which are no references.
template <class Value>
std::size_t restore(std::istream&, Value&&, bool = false, bool = true) {
  return 0;
}

}  // namespace OpenMesh::IO

#endif
