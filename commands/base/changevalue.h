// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/mergeid.h"
#include <QUndoCommand>

#include <type_traits>
#include <utility>

namespace commands {

/// A command that gives one value of the document another one. Undo and redo are the same swap of the value in the
/// document with the one kept here. A concrete command is its constructor: the text and the wanted value.
///
/// Made for the document as it is at that moment, and to be pushed at once. Obsolete from the start if it would change
/// nothing (EditContext drops it), and once a gesture has come back to where it began (the undo stack drops it).
/// \tparam Getter, Setter  members of Document; the setter returns the value that it replaced
template <class Document, auto Getter, auto Setter>
class ChangeValue : public QUndoCommand
{
public:
    using Value = std::remove_cvref_t<std::invoke_result_t<decltype(Getter), const Document &>>;

    void redo() final { swap(); }
    void undo() final { swap(); }
    int id() const final { return mGesture == NoGesture ? -1 : int(mMergeId); }
    /// Called by the undo stack with a command of the same id() that has been carried out already: this one then leads
    /// from its own old value to the newer one's new value, and says so.
    bool mergeWith(const QUndoCommand *newer) final
    {
        if (static_cast<const ChangeValue *>(newer)->mGesture != mGesture)
            return false;
        setText(newer->text());
        setObsolete((mDocument.*Getter)() == mOther);
        return true;
    }

protected:
    ChangeValue(Document &document, const QString &text, Value wanted)
        : ChangeValue(document, text, std::move(wanted), MergeId(), NoGesture)
    {}
    ChangeValue(Document &document, const QString &text, Value wanted, MergeId mergeId, GestureId gesture)
        : QUndoCommand(text)
        , mDocument(document)
        , mOther(std::move(wanted))
        , mMergeId(mergeId)
        , mGesture(gesture)
    {
        setObsolete((mDocument.*Getter)() == mOther);
    }

private:
    void swap() { mOther = (mDocument.*Setter)(std::move(mOther)); }

    Document &mDocument;
    Value mOther; ///< the value that the document does not hold now
    const MergeId mMergeId;
    const GestureId mGesture;
};

} // namespace commands
