// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/terrain/setmask.h"

namespace commands {

SetMask::SetMask(std::shared_ptr<model::GroundMask> mask, const QString &text, model::GroundMask::Value value)
    : WeightedCommand(text)
    , mMask(std::move(mask))
    , mOther(value && !value->isEmpty() ? std::move(value) : nullptr)
{
    const model::GroundMask::Value &now = mMask->value();
    setObsolete(now == mOther || (now && mOther && *now == *mOther));
}

std::size_t SetMask::byteSize() const
{
    return sizeof(*this) + (mOther ? mOther->values().size() : 0);
}

} // namespace commands
