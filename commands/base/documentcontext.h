// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/base/editcontext.h"

#include <utility>

namespace commands {

/// The way to change a document of one kind: views hold one, read the document through it, and push commands.
template <class Document>
class DocumentContext : public EditContext
{
public:
    const Document &document() const { return mDocument; }

    /// Carries out Command(document, args...) and remembers it: `context.push<TrimAnimation>(first, last)`.
    template <class Command, class... Args>
    void push(Args &&...args)
    {
        pushCommand(std::make_unique<Command>(mDocument, std::forward<Args>(args)...));
    }

protected:
    explicit DocumentContext(Document &document, QObject *parent)
        : EditContext(parent)
        , mDocument(document)
    {}

    Document &mDocument;
};

} // namespace commands
