// The voxel model in a file of its own beside the document: voxel kinds, posture, materials, and the key of the
// inputs they were made from, so that a model is taken from the file only if nothing has changed. The
// feed field is a closed form and is made anew.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/dcm/posture_field.h"

#include <optional>
#include <string>

namespace patchmill::dcm {

/// A grid with its fields, as one file keeps them.
struct VoxelModel {
  voxel::VoxelGrid grid;
  std::optional<PostureField> posture;
  std::vector<std::uint8_t> material;  ///< materials.h; empty if there is only the stock's own
};

/// Writes `path`; half a file is left if that fails, so that callers who replace one write another and rename it.
/// `key` says what the model was made from. Errors: InputError naming the file if it cannot be written.
void write_voxel_model(const std::string& path, const std::string& key, const VoxelModel& model);

/// The model in the file, or nothing if there is no such file, its key is another, or it is not
/// whole, or is a device or a pipe: then it is to be made anew. Takes no more memory than the file is long.
std::optional<VoxelModel> read_voxel_model(const std::string& path, const std::string& key);

}  // namespace patchmill::dcm
