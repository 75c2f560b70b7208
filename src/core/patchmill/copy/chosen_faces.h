// Copy milling of some of a part's faces: of the path over the whole part, which gouges nowhere, what works on
// them. A place is kept if the ball touches a chosen face there, or would if it were lowered on the part: so
// the layers above a face are kept with it, and what lies beside it is not touched. At an edge of the faces the
// ball rolls on by 60 degrees, so that they are finished up to the edge.
// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include "patchmill/copy/copy_milling.h"

namespace patchmill::copy {

/// The cuts of `path`, made by copy_mill of `part` with `options` in scanning or contour lines, on the places
/// where the ball works on `faces`, a mesh of some of the part's faces. Along a cut the limits are found to the
/// tolerance; a stretch shorter than a quarter of the radius may be missed. It has no moves if the ball comes
/// on none of them. Errors: InputError as of require_valid. If `progress` asks for a stop, the path is what was
/// done so far.
ToolPath over_faces(const ToolPath& path, const mesh::TriangleBvh& part,
                    const mesh::TriangleBvh& faces, const CopyOptions& options,
                    const Progress& progress = {});

}  // namespace patchmill::copy
