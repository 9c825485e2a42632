// Takes the place of OpenMesh's header of this name: see StoreRestore.hh beside it.
#ifndef FOLDWRIGHT_OPENMESH_SR_STORE_HH
#define FOLDWRIGHT_OPENMESH_SR_STORE_HH

#include <OpenMesh/Core/IO/StoreRestore.hh>

#endif
