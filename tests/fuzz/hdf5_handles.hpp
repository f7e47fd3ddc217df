#pragma once

#include <hdf5.h>

#include "accepted.hpp"

namespace beadswim {

/// Calls a function and requires that it closes all HDF5 files, datasets, groups, types and attributes that
/// it opens.
template <class Function>
void require_all_closed_by(const Function& function) {
  const ssize_t before = H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_ALL);
  function();
  require(H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_ALL) == before, "all that is opened is closed");
}

}  // namespace beadswim
