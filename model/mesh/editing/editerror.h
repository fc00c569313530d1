// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/editing/editedmesh.h"

#include <tl/expected.hpp>

namespace model {

/// Why an edit cannot be made. The text for people is made where it is shown; `vertices` can be shown with it.
struct EditError
{
    enum class Kind : std::uint8_t {
        /// The edit needs an oriented manifold. Vertices: those of edges with more than two faces or two that run the
        /// same
        /// way, of vertices with several fans, of degenerate faces.
        NotManifold,
        BadLoop, ///< no loop of edges that have two faces each; vertices: two that no such edge joins, or one twice
        LoopAtBorder, ///< the loop touches holes on both of its sides, which have to be filled first; vertices: one
                      ///< there
        Cancelled,
    };
    Kind kind;
    std::vector<std::uint32_t> vertices;
};

using EditResult = tl::expected<EditedMesh, EditError>;

inline tl::unexpected<EditError> failEdit(EditError::Kind kind, std::vector<std::uint32_t> vertices = {})
{
    return tl::unexpected(EditError{kind, std::move(vertices)});
}

} // namespace model
