// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/terrain/historybudget.h"
#include "model/document/groundmask.h"

namespace commands {

/// Gives a document another painted mask. Obsolete if it protects the same.
class SetMask final : public WeightedCommand
{
public:
    /// \param mask   of the document; kept alive
    /// \param value  null or an empty one: nothing is protected
    SetMask(std::shared_ptr<model::GroundMask> mask, const QString &text, model::GroundMask::Value value);

    void redo() override { mOther = mMask->setValue(mOther); }
    void undo() override { mOther = mMask->setValue(mOther); }
    std::size_t byteSize() const override;

private:
    const std::shared_ptr<model::GroundMask> mMask;
    model::GroundMask::Value mOther; ///< that the document does not have now
};

} // namespace commands
