// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/terrain/tools/paintmask.h"

#include <QObject>

#include <memory>

namespace model {

/// The painted mask of a document: commands replace it, tools and views look at it. It goes into the file with the
/// state of the tools, and is no part of the terrain itself.
class GroundMask final : public QObject
{
    Q_OBJECT

public:
    using Value = std::shared_ptr<const terrain::PaintMask>;

    explicit GroundMask(Value value = nullptr)
        : mValue(std::move(value))
    {}

    /// Null: nothing is protected.
    const Value &value() const { return mValue; }
    /// \returns the one before
    Value setValue(Value value);

signals:
    void changed();

private:
    Value mValue;
};

} // namespace model
