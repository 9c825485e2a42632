// Takes the place of OpenMesh's BaseProperty.cc, which prints to a stream: see OpenMesh/Core/IO/StoreRestore.hh.
#include <OpenMesh/Core/Utils/BaseProperty.hh>

namespace OpenMesh {

void BaseProperty::stats(std::ostream&) const {}

}  // namespace OpenMesh
