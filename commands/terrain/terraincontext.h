// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/documentcontext.h"
#include "model/document/terraindocument.h"

namespace commands {

/// The way to change a terrain.
class TerrainContext final : public DocumentContext<model::TerrainDocument>
{
public:
    explicit TerrainContext(model::TerrainDocument &document, QObject *parent = nullptr)
        : DocumentContext(document, parent)
    {}
};

} // namespace commands
