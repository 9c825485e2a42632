// Takes the place of OpenMesh's header of this name: what OpenMesh would print nobody reads, and its streams bring all
// locales into the WASM module. Failures are seen by what its functions return.
#ifndef FOLDWRIGHT_OPENMESH_OMSTREAM_HH
#define FOLDWRIGHT_OPENMESH_OMSTREAM_HH

#include <ostream>

namespace OpenMesh {

/// A stream that swallows what is written to it.
struct mostream {
  template <class Value>
  mostream& operator<<(const Value&) {
    return *this;
  }
  mostream& operator<<(std::ostream& (*)(std::ostream&)) { return *this; }  // std::endl
};

}  // namespace OpenMesh

inline OpenMesh::mostream omlog() { return {}; }
inline OpenMesh::mostream omout() { return {}; }
inline OpenMesh::mostream omerr() { return {}; }

#endif
